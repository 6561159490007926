// Reference meshes: the surface of an implicit solid, finely polygonised.
//
// Marching tetrahedra on the body-centred cubic lattice (every tetrahedral
// lattice gives a closed 2-manifold, whatever the signs at its nodes; this
// one gives well-shaped triangles), then every vertex is moved onto the
// surface. Shares no code with octacut's own surface extraction, so it may
// judge it.
#pragma once

#include "core/base/context.h"
#include "core/benchmark/synthetic/implicit.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct PolygonizeOptions {
  // Lattice cells along the longest edge of the shape's box.
  int resolution = 200;
  // Rounds of moving vertices along the surface toward their neighbours'
  // mean, for evenly sized triangles.
  int smoothing_rounds = 2;

  void Check() const;  // throws OptionError
};

// Closed and outward oriented, with vertex normals from the gradient. Parts
// thinner than a cell may be lost. Throws InvariantError when the surface
// crosses a cell that the shape's Lipschitz bound excludes (the bound is
// wrong), InputError when there is no surface.
IndexedMesh Polygonize(const ImplicitShape& shape,
                       const PolygonizeOptions& options,
                       const Context& context);

}  // namespace octacut
