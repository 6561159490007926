// Swept depths that the surfaces of other views contradict.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/context.h"
#include "core/evidence/depth_sweep.h"
#include "core/grid/voxel_grid.h"
#include "core/views/view_set.h"

namespace octacut {

// What is known of the samples of a map; each image holds 0 or 1 for each.
struct JudgedMap {
  cv::Mat1b is_depth;  // it has one
  // The ray passes through a surface that enough other views have found, well
  // before the depth.
  cv::Mat1b is_contradicted;
  // Or within a voxel of one, as rays into a cup pass its rim. Right depths in
  // hollows are among them, but where few depths are found only they show which
  // contradict each other.
  cv::Mat1b is_nearly_contradicted;
  // There, more views have found a surface than at the depth.
  cv::Mat1b is_outvoted;
};

// For each view's map.
std::vector<JudgedMap> JudgeDepths(const ViewSet& views,
                                   const VoxelGrid& hull,
                                   const std::vector<SweptDepthMap>& maps,
                                   const Context& context);

// `maps` without the depths that are outvoted.
std::vector<SweptDepthMap> WithoutOutvoted(
    std::vector<SweptDepthMap> maps, const std::vector<JudgedMap>& judged);

}  // namespace octacut
