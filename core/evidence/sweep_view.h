// A view reduced to the scale of a depth sweep. For core/evidence alone.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/grid/voxel_grid.h"
#include "core/views/view_set.h"

namespace octacut {

// Grey values, and the interval of depths (unit coordinates) that the hull
// occupies along each sample's ray. One sample is 1 / scale pixels.
struct SweepView {
  const ViewProjection* projection = nullptr;
  float scale = 1;
  cv::Mat_<float> grey;
  cv::Mat_<float> near_depth;  // infinity where the ray misses the hull
  cv::Mat_<float> far_depth;   // 0 there
};

// `samples_per_voxel`: samples across a voxel of the hull at the cube's
// centre, never finer than the view's pixels.
SweepView ReduceForSweep(const PreparedView& view,
                         const VoxelGrid& hull,
                         double samples_per_voxel);

}  // namespace octacut
