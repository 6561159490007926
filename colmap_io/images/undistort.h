// Undistortion in memory: photographs and masks of any perspective camera
// model, resampled to a pinhole camera of the same centre and axes.
#pragma once

#include <opencv2/core/mat.hpp>

#include "colmap_io/model/camera_models.h"
#include "core/base/context.h"
#include "core/scene/camera.h"

namespace octacut {

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

// CV_8UC1, 255 at the target pixels that `source` does not cover; empty where
// it covers all. `undistorted` is Undistort(source, camera, target, 255), of
// one channel.
cv::Mat FindUncovered(const cv::Mat& source,
                      const SparseCamera& camera,
                      const PinholeCamera& target,
                      const cv::Mat& undistorted,
                      const Context& context);

}  // namespace octacut
