// Vertex normals of a triangle mesh.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

// Unit normals, each the sum of the normals of the vertex's triangles weighted
// by their angle at the vertex (Thuermer & Wuethrich 1998), which does not
// depend on how a polygon was triangulated. Vertices without a triangle of
// positive area get (0, 0, 1).
std::vector<Eigen::Vector3f> ComputeVertexNormals(const IndexedMesh& mesh,
                                                  const Context& context);

}  // namespace octacut
