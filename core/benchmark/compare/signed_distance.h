// Distances of points to a surface, with the side on which they lie.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/benchmark/compare/reference_filter.h"
#include "core/mesh/indexed_mesh.h"
#include "core/raycast/ray_scene.h"

namespace octacut {

// For each point the distance to the closest point of `surface`, positive on
// the side to which its triangles face, negative on the other. On edges and
// vertices the side is that of the angle-weighted pseudonormal (Baerentzen &
// Aanaes 2005), which is exact for closed surfaces; near the border of an open
// one the sign means little. A cloud (PointsAsTriangles) has no sides: all
// distances are positive. `rays` is of the same mesh. Not a number where
// the closest point does not count by `filter`. The same values for any number
// of threads.
std::vector<float> SignedDistances(const std::vector<Eigen::Vector3d>& points,
                                   const IndexedMesh& surface,
                                   const RayScene& rays,
                                   const Context& context,
                                   const ReferenceFilter& filter = {});

// Makes the values of the reference's vertices that do not count by `filter`
// not a number.
void DropUnjudged(const IndexedMesh& reference,
                  const ReferenceFilter& filter,
                  std::vector<float>* values);

}  // namespace octacut
