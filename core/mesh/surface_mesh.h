// The half-edge mesh of a reconstruction: an OpenMesh triangle mesh in world
// coordinates, with vertex normals and colours.
//
// It is what a reconstruction gives. The steps that make it, the audit, which
// must not rely on OpenMesh, and files have the flat IndexedMesh.
#pragma once

// In this order: the second header specialises what the first one declares.
// clang-format off
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Geometry/EigenVectorT.hh>
// clang-format on

#include "core/mesh/indexed_mesh.h"

namespace octacut {

// No status: nothing is ever marked as deleted. Normals and colours take
// memory from the time that they are requested.
struct SurfaceMeshTraits : OpenMesh::DefaultTraits {
  using Point = Eigen::Vector3d;
  using Normal = Eigen::Vector3d;  // as points: OpenMesh casts between both
  using Color = OpenMesh::Vec3uc;  // red, green, blue
};
using SurfaceMesh = OpenMesh::TriMesh_ArrayKernelT<SurfaceMeshTraits>;

// Vertices and triangles keep their numbers, and triangles their first corner,
// both ways; normals and colours are taken over where they are. Throws
// InvariantError when `mesh` is no 2-manifold (OpenMesh refuses one of its
// triangles).
SurfaceMesh ToSurfaceMesh(const IndexedMesh& mesh);
IndexedMesh ToIndexedMesh(const SurfaceMesh& mesh);

}  // namespace octacut

// Made in surface_mesh.cc alone.
extern template class OpenMesh::PropertyT<octacut::SurfaceMesh::Point>;
extern template class OpenMesh::PropertyT<octacut::SurfaceMesh::Color>;
