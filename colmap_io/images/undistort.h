// Undistortion in memory: photographs and masks of any perspective camera
// model, resampled to a pinhole camera of the same centre and axes.
#pragma once

#include <opencv2/core/mat.hpp>

#include "colmap_io/model/camera_models.h"
#include "core/base/context.h"
#include "core/scene/camera.h"

namespace octacut {

// True when the camera is a pinhole: by its model, or by a model of lens
// distortion whose coefficients are all zero (below 1e-8, as COLMAP has it).
// image_undistorter leaves such images and cameras as they are.
bool IsPinhole(const SparseCamera& camera);

// The camera that COLMAP's image_undistorter makes of `camera` with its
// defaults (blank_pixels 0, scale 0.2 to 2, no limit of size): the same focal
// lengths; size and principal point such that no pixel is blank. Follows
// UndistortCamera in COLMAP's image/undistortion.cc. A camera without
// distortion keeps its parameters.
PinholeCamera UndistortedCamera(const SparseCamera& camera);

// `source`, CV_8UC3 or CV_8UC1 of the size of `camera`, as `target` sees it:
// bilinear interpolation; where the target is coarser, the mean over the
// target pixel, so that nothing is aliased. Where `target` is a window of the
// source at its own scale and pixel positions, pixels are copied exactly.
//
// A target pixel of which a part is not covered by the source gets `uncovered`
// in all channels.
cv::Mat Undistort(const cv::Mat& source,
                  const SparseCamera& camera,
                  const PinholeCamera& target,
                  uint8_t uncovered,
                  const Context& context);

}  // namespace octacut
