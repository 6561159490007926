// Depth maps of the views by plane sweeping alone, at the views' resolution:
// what a dense reconstruction can be fused from that knows no mesh.
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/context.h"
#include "core/scene/scene.h"

namespace octacut {

struct DenseDepthsOptions {
  // Level of the visual hull in which depths are looked for. Samples of the
  // sweep are half a voxel of (2^level)^3 apart, and depths are refined between
  // them. A finer level has smaller windows: of the temple, level 8 finds a
  // quarter fewer depths than level 7, in six times the time.
  int level = 7;

  void Check() const;  // throws OptionError
};

// For each view the depth along its optical axis in world units, CV_32FC1 of
// its size; 0 where none was found, where fewer than two others confirm it,
// where more views have found a surface before it, and off the object. `box`
// (world) clips the hull. The same values for any number of threads. Throws
// InputError when the hull is empty.
std::vector<cv::Mat> SweepDenseDepths(const Scene& scene,
                                      const BoundingCube& cube,
                                      const Eigen::AlignedBox3d& box,
                                      const DenseDepthsOptions& options,
                                      const Context& context);

}  // namespace octacut
