// Fewer triangles for a closed mesh, without giving up what makes it closed.
#pragma once

#include <cstddef>
#include <functional>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/simplify/apply_collapses.h"

namespace octacut {

struct SimplifySummary {
  // Times that the mesh was simplified anew because triangles intersected.
  size_t num_repairs = 0;
  // Vertices of the full mesh that had to stay because of that.
  size_t num_held = 0;
  // Intersecting pairs of triangles that the full mesh has already.
  size_t num_old_intersections = 0;
};

struct SimplifiedMesh {
  // With normals. Its vertices, with their colours and confidence, are some of
  // those of the full mesh. A closed 2-manifold as far as the full mesh is
  // one, without intersections but those of the full mesh.
  IndexedMesh mesh;
  SimplifySummary summary;
};

// At most `num_triangles`, or as few as the collapses allow.
SimplifiedMesh SimplifyTo(size_t num_triangles,
                          const CollapseReplay& replay,
                          const Context& context);

// As few triangles as a search finds such that `distance_to_full`, a distance
// in the units of the mesh, is at most `max_distance`. It must be 0 for the
// full mesh.
SimplifiedMesh SimplifyWithin(
    double max_distance,
    const std::function<double(const IndexedMesh&)>& distance_to_full,
    const CollapseReplay& replay,
    const Context& context);

}  // namespace octacut
