// The part of a reference surface that the photographs show: what no camera
// sees says nothing about a reconstruction.
#pragma once

#include <vector>

#include "core/benchmark/compare/reference_filter.h"
#include "core/mesh/indexed_mesh.h"
#include "core/scene/camera.h"

namespace octacut {

struct PosedCamera {
  PinholeCamera camera;
  Rigid3d cam_from_world;
};

struct SeenReferenceOptions {
  int min_views = 3;
  // The largest angle between a view and the surface's normal at which it
  // counts, degrees; 1 .. 90.
  double max_angle = 75;

  void Check() const;  // throws OptionError
};

// True for the points of `reference` that at least min_views cameras see: in
// the frame, from the front (by the triangle's orientation), not hidden by the
// reference itself. Cameras and reference share a frame and a unit. Throws as
// RayScene does, and InputError when there are fewer than min_views cameras.
ReferenceFilter SeenByCameras(const IndexedMesh& reference,
                              std::vector<PosedCamera> cameras,
                              const SeenReferenceOptions& options);

}  // namespace octacut
