// The frame of one reconstruction in that of another one of the same
// photographs, by the poses that both give to these.
#pragma once

#include <cstddef>
#include <vector>

#include "core/mesh/similarity.h"
#include "core/scene/camera.h"

namespace octacut {

// The poses of one photograph in both frames.
struct SharedCamera {
  Rigid3d cam_from_model;
  Rigid3d cam_from_reference;
};

struct SharedCameraAlignment {
  Similarity3d reference_from_model;
  // Cameras whose centres agree to three times the median or better.
  size_t num_inliers = 0;
  // Of their centres, units of the reference.
  double rms = 0;
};

// Rotation by the cameras' own, which also serves where their centres lie on a
// line, scale and translation by the centres. Cameras farther off than three
// times the median, which one of the two reconstructions has put elsewhere, are
// left out. Throws InputError for fewer than three cameras, or if the centres
// of either frame coincide.
SharedCameraAlignment AlignSharedCameras(
    const std::vector<SharedCamera>& cameras);

}  // namespace octacut
