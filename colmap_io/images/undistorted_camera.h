// The pinhole cameras that image_undistorter makes.
#pragma once

#include "colmap_io/model/camera_models.h"
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

}  // namespace octacut
