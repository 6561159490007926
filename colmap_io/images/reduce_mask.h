// Small, conservative, undistorted masks: what finding the region needs.
#pragma once

#include <opencv2/core/mat.hpp>

#include "colmap_io/images/view_window.h"
#include "colmap_io/model/camera_models.h"
#include "core/scene/camera.h"

namespace octacut {

struct ReducedMask {
  PinholeCamera camera;
  cv::Mat mask;  // CV_8UC1, 0 or 255
};

// The mask (View::mask, of the size of `camera`) at about `max_size` pixels on
// its longer side, as a pinhole camera sees it. A pixel is 255 when any pixel
// of `mask` that it may show is object.
//
// When the object stays clear of the photograph's border, the result ends just
// outside of the object, so that it does not touch the result's border either,
// and is 0 wherever the photograph does not reach. Otherwise the result has the
// whole frame and is 255 there.
ReducedMask ReduceMask(const cv::Mat& mask,
                       const SparseCamera& camera,
                       const Frame& frame,
                       int max_size);

}  // namespace octacut
