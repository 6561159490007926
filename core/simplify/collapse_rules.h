// Which edge collapses keep a mesh a 2-manifold of well-shaped triangles.
#pragma once

#include "core/mesh/surface_mesh.h"

namespace octacut {

// Whether moving the half-edge's first vertex onto its second one keeps the
// triangles that remain facing the way they do, and from becoming needles. The
// vertices must not be deleted.
bool KeepsTriangleShapes(const SurfaceMesh& mesh,
                         SurfaceMesh::HalfedgeHandle edge);

// Whether the collapse leaves a closed 2-manifold. The mesh must have status
// attributes.
bool KeepsManifold(SurfaceMesh& mesh, SurfaceMesh::HalfedgeHandle edge);

}  // namespace octacut
