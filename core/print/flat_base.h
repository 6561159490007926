// Cuts the foot off a closed mesh and closes it with a flat base.
#pragma once

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct FlatBase {
  // What lay above the plane z = 0, closed by triangles in that plane. Without
  // normals and confidence.
  IndexedMesh mesh;
  double area = 0;         // of the base
  size_t num_islands = 0;  // pieces of the base that do not hang together
};

// `mesh` must be a closed 2-manifold whose positions are floats and that has
// vertices on both sides of the plane. Vertices closer to it than a twentieth
// of the mean length of an edge, or 1e-4 of the mesh's size if that is less,
// are moved up or down to that distance, so that no triangle is cut near a
// corner. Colours along the cut are those between the ends of the edges that
// are cut.
//
// Throws InputError where the cut does not leave a closed 2-manifold, or where
// triangles at the cut intersect others: the mesh does so itself there; and
// where nothing is below the plane once vertices are moved.
FlatBase CutFlatBase(const IndexedMesh& mesh, const Context& context);

}  // namespace octacut
