// Small meshes for tests.
#pragma once

#include "core/mesh/indexed_mesh.h"

namespace octacut {

IndexedMesh MakeTetrahedron();  // volume 1/6
// [0, 1]^3, two triangles a side.
IndexedMesh MakeBox();
// A regular octahedron with unit vertices.
IndexedMesh MakeOctahedron();
// `a` and `b` as one mesh, `b` moved.
IndexedMesh Combine(const IndexedMesh& a,
                    const IndexedMesh& b,
                    const Eigen::Vector3d& move_b);
// Triangles the other way round.
IndexedMesh TurnInsideOut(IndexedMesh mesh);

}  // namespace octacut
