// The plane that an object stands on, from what was reconstructed around it.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

// What is around the object, in the frame of its mesh.
struct Surroundings {
  std::vector<Eigen::Vector3d> points;  // also those on the object
  std::vector<Eigen::Vector3d> camera_centers;
  double noise = 0;  // expected error of a point
};

struct RestingPlane {
  // Unit normal, to the side of the object; `up`.dot(x) = `offset` for points x
  // of the plane.
  Eigen::Vector3d up;
  double offset = 0;
  size_t num_points = 0;      // on the plane
  size_t num_candidates = 0;  // around the object, but not on it
  double rms = 0;             // distance of the points on the plane
  // From the plane to the lowest point of the mesh, negative where that is
  // below it.
  double gap = 0;
};

// The plane that the most points lie on (RANSAC, then least squares), of those
// that have the object and at least half of the cameras on one side and the
// lowest point of the mesh closer than a tenth of the diagonal of its bounding
// box. Only points within twice the diagonal count. Depends on Context::Seed().
// Throws InputError where no plane has 20 points and a tenth of those around.
RestingPlane FindRestingPlane(const IndexedMesh& mesh,
                              const Surroundings& surroundings,
                              const Context& context);

}  // namespace octacut
