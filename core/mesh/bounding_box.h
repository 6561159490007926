#pragma once

#include <Eigen/Geometry>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

// The box around all vertices, in the mesh's coordinates; empty without any.
inline Eigen::AlignedBox3d BoundingBox(const IndexedMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& position : mesh.positions) {
    box.extend(position);
  }
  return box;
}

// The box around the triangles alone: vertices that none of them has as a
// corner do not count.
inline Eigen::AlignedBox3d BoxOfTriangles(const IndexedMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t corner : triangle) {
      box.extend(mesh.positions[corner]);
    }
  }
  return box;
}

}  // namespace octacut
