// Correlation of a view with its neighbours at every depth of every ray. For
// core/evidence alone.
#pragma once

#include <cstddef>
#include <opencv2/core/types.hpp>
#include <vector>

#include "core/evidence/depth_sweep.h"
#include "core/evidence/sweep_view.h"

namespace octacut {

// Scores of all planes of one view: scores[plane * num_rays + ray]; -1 where
// the plane is not in the hull. Empty when the view does not see it.
struct ScoreVolume {
  cv::Rect frame;  // samples whose rays there are, row by row
  int num_planes = 0;
  size_t num_rays = 0;
  float first_depth = 0;  // unit coordinates
  float spacing = 0;
  std::vector<float> scores;
};

// Zero-mean normalised cross-correlation of the windows that `options` have,
// the mean over the best half of the neighbours; `one_is_enough`: or that of
// the best one less 0.1, where that is more, for points that few views see.
ScoreVolume ScorePlanes(const std::vector<SweepView>& views,
                        int reference,
                        const std::vector<int>& neighbors,
                        float plane_spacing,
                        const DepthSweepOptions& options,
                        bool one_is_enough = false);

}  // namespace octacut
