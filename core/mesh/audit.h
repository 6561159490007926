// What a triangle mesh is, measured: topology, size, defects.
#pragma once

#include <cstddef>
#include <cstdint>
#include <Eigen/Geometry>
#include <string>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

// Works for any mesh, open and non-manifold ones too.
//
// Topology goes by vertex indices, not by positions. Triangles that repeat an
// index, or have a vertex that is not finite, count as defects and are left
// out of all else.
struct MeshAudit {
  size_t num_vertices = 0;
  size_t num_triangles = 0;
  size_t num_edges = 0;

  size_t num_boundary_edges = 0;     // edges with one triangle
  size_t num_nonmanifold_edges = 0;  // edges with more than two triangles
  size_t num_misoriented_edges = 0;  // two triangles run along it one way
  // Vertices whose triangles are not one fan, closed or open.
  size_t num_nonmanifold_vertices = 0;
  size_t num_unreferenced_vertices = 0;
  // Repeated indices, or no area: the height over the longest edge is at most
  // 1e-10 of that edge.
  size_t num_degenerate_triangles = 0;
  size_t num_duplicate_triangles = 0;  // same three vertices as an earlier one
  size_t num_nonfinite_vertices = 0;

  // Connected through shared vertices; unreferenced vertices are none.
  size_t num_components = 0;
  // Vertices (referenced ones) - edges + triangles.
  int64_t euler_characteristic = 0;
  // Sum over the components; -1 unless closed, manifold and oriented.
  int64_t genus = -1;

  double area = 0;
  // Signed: positive when the triangles face outward. Of a mesh that is not
  // closed it depends on the position and means nothing.
  double volume = 0;
  Eigen::AlignedBox3d bounding_box;  // of the referenced finite vertices

  bool IsClosed() const { return num_triangles > 0 && num_boundary_edges == 0; }
  bool IsEdgeManifold() const { return num_nonmanifold_edges == 0; }
  bool IsVertexManifold() const { return num_nonmanifold_vertices == 0; }
  bool IsOriented() const { return num_misoriented_edges == 0; }
  bool IsOutward() const { return volume > 0; }
  // Names with its count what breaks the promise that each reconstruction
  // keeps; empty when nothing does: non-empty, finite, closed, manifold at
  // every edge and vertex, oriented outward, no degenerate or duplicate
  // triangle, no unreferenced vertex.
  std::string DescribeFailure() const;
};

// Throws InputError when an index is out of range.
MeshAudit AuditMesh(const IndexedMesh& mesh, const Context& context);

// Throws InvariantError that names what fails, if anything does.
void CheckAudit(const MeshAudit& audit);

}  // namespace octacut
