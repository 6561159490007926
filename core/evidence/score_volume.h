// Correlation of a view with its neighbours at every depth of every ray. For
// core/evidence alone.
#pragma once

#include <cstddef>
#include <opencv2/core/types.hpp>
#include <vector>

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

struct ScoreOptions {
  float plane_spacing = 0;  // unit coordinates
  int window_radius = 2;    // windows have (2 window_radius + 1)^2 samples
  // As in DepthSweepOptions.
  float plain_deviation = 2;
  // Where the best neighbour's correlation less 0.1 is more than the mean over
  // the best half, it counts: for points that few views see.
  bool one_is_enough = false;
};

// Zero-mean normalised cross-correlation of windows, the mean over the best
// half of the neighbours.
ScoreVolume ScorePlanes(const std::vector<SweepView>& views,
                        int reference,
                        const std::vector<int>& neighbors,
                        const ScoreOptions& options);

}  // namespace octacut
