// Photographs as small pinhole views, and values of such views carried back to
// the photographs: for what looks at whole photographs, as segmentation does.
#pragma once

#include <opencv2/core/mat.hpp>

#include "colmap_io/model/camera_models.h"
#include "core/scene/camera.h"

namespace octacut {

// The pinhole camera that shows all of the photograph (up to 72 degrees off
// the axis) with at most `longest_side` pixels along a side, and no more than
// the photograph itself has.
PinholeCamera ReducedCamera(const SparseCamera& camera, int longest_side);

// `photograph` (CV_8UC3 or CV_8UC1, of the camera's size) as `target` sees it.
// Where it shows nothing, its border goes on.
cv::Mat ReduceView(const cv::Mat& photograph,
                   const SparseCamera& camera,
                   const PinholeCamera& target);

// `values` (CV_32F, of the size of `reduced`) at the pixels of the photograph
// that `camera` took, at its full size, by linear interpolation. Where
// `reduced` shows nothing, the values at its border go on; pixels that the lens
// gives no ray are 0.
cv::Mat CarryBack(const cv::Mat& values,
                  const PinholeCamera& reduced,
                  const SparseCamera& camera);

}  // namespace octacut
