// A mesh in unit coordinates, for rays there.
#pragma once

#include "core/mesh/indexed_mesh.h"
#include "core/scene/scene.h"

namespace octacut {

// Positions and triangles of `mesh`, without the values of its vertices; the
// positions in the unit coordinates of `cube`.
IndexedMesh UnitMesh(const IndexedMesh& mesh, const BoundingCube& cube);

}  // namespace octacut
