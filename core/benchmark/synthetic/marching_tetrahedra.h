// The first, coarse polyhedron of an implicit surface.
#pragma once

#include "core/base/context.h"
#include "core/benchmark/synthetic/implicit.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct MarchedSurface {
  IndexedMesh mesh;  // positions and triangles, oriented outward
  double cell;       // edge of a lattice cell
};

// Marching tetrahedra on the body-centred cubic lattice with `resolution`
// cells along the longest edge of the shape's box. The vertices lie within a
// cell of the surface. No triangles where there is no surface.
MarchedSurface MarchTetrahedra(const ImplicitShape& shape,
                               int resolution,
                               const Context& context);

}  // namespace octacut
