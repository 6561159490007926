// From points that have moved to the vertices between them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/refine/local_surface.h"
#include "core/refine/surface_points.h"

namespace octacut {

struct MovedPoints {
  std::vector<LocalSurface> surfaces;
  std::vector<double> offsets;          // of the surfaces, along their normals
  std::vector<Eigen::Vector3f> slopes;  // of the offsets
  // 0: vertices close to the point stay where they are.
  std::vector<uint8_t> is_free;
  // 0: they keep their distances from the surface, steps and all.
  std::vector<uint8_t> is_smooth;
};

// Moves each vertex of `mesh`, which has normals, to a mean of what the moved
// surfaces of the points around it say; those within `radius` count, the less
// the farther they are. A vertex whose own point is not free keeps its
// position exactly. Unit coordinates. Returns the mean way of the others.
double MoveVertices(const SurfacePoints& points,
                    const MovedPoints& moved,
                    double radius,
                    const Context& context,
                    IndexedMesh* mesh);

}  // namespace octacut
