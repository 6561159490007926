// The order in which simplification removes the vertices of a mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/surface_mesh.h"

namespace octacut {

// Vertex `from` is moved onto its neighbour `to`, and both become one, which
// takes two triangles.
struct Collapse {
  uint32_t from;
  uint32_t to;
};

// Collapses that take the mesh, which must be closed, down to `num_triangles`,
// or as far as possible: each time the one with the least quadric error
// (Garland & Heckbert, SIGGRAPH 1997) of those that collapse_rules.h allows.
// OpenMesh's decimater finds them. Any beginning of the sequence leaves a
// closed 2-manifold, whose vertices are some of the mesh's. The same for any
// number of threads; runs on one.
std::vector<Collapse> FindCollapses(SurfaceMesh mesh,
                                    size_t num_triangles,
                                    const Context& context);

}  // namespace octacut
