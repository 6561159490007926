// Swept depths that the surfaces of other views contradict.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/context.h"
#include "core/evidence/depth_sweep.h"
#include "core/grid/voxel_grid.h"
#include "core/views/view_set.h"

namespace octacut {

// Which samples of a map have a depth, which of those are contradicted by
// surfaces that their ray passes through, and which are outvoted by those that
// it passes within a voxel. Nearly contradicted are also depths whose ray
// passes a surface within a voxel, as rays into a cup pass its rim: right
// depths in hollows are among them, but where few depths are found only they
// show which contradict each other.
//
// The images hold 0 or 1 for each sample of the map.
struct JudgedMap {
  cv::Mat1b is_depth;
  cv::Mat1b is_contradicted;
  cv::Mat1b is_nearly_contradicted;
  cv::Mat1b is_outvoted;
};

// For each view's map.
std::vector<JudgedMap> JudgeDepths(const ViewSet& views,
                                   const VoxelGrid& hull,
                                   const std::vector<SweptDepthMap>& maps,
                                   const Context& context);

}  // namespace octacut
