// The half-edge mesh of a reconstruction: an OpenMesh triangle mesh in world
// coordinates with vertex normals and colours. OpenMesh stays in core/mesh
// and refinement code; everyone else passes IndexedMesh.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct SurfaceMeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3f;
  using Color = OpenMesh::Vec3uc;
  VertexAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::None);
};
using SurfaceMesh = OpenMesh::TriMesh_ArrayKernelT<SurfaceMeshTraits>;

// Throws InvariantError when `mesh` is no 2-manifold (OpenMesh refuses one of
// its triangles).
SurfaceMesh ToSurfaceMesh(const IndexedMesh& mesh);
IndexedMesh ToIndexedMesh(const SurfaceMesh& mesh);

}  // namespace octacut
