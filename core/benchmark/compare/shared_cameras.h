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
  // Cameras whose centres agree to three times the median or better: at least
  // half of all.
  size_t num_inliers = 0;
  // Root mean squares, units of the reference: of how far their centres are
  // apart, and of how far those are from their mean.
  double rms = 0;
  double spread = 0;
};

// Rotation by the cameras' own, which also serves where their centres lie on a
// line, scale and translation by the centres. Cameras farther off than three
// times the median, which one of the two reconstructions has put elsewhere, are
// left out. Throws InputError for fewer than three cameras, or if the centres
// of either frame coincide.
SharedCameraAlignment AlignSharedCameras(
    const std::vector<SharedCamera>& cameras);

}  // namespace octacut
