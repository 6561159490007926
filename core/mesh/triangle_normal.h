// Normals and areas of the triangles of a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

// The outward normal, as long as twice the triangle's area.
inline Eigen::Vector3d AreaNormal(const IndexedMesh& mesh,
                                  const std::array<uint32_t, 3>& triangle) {
  const Eigen::Vector3d& a = mesh.positions[triangle[0]];
  return (mesh.positions[triangle[1]] - a)
      .cross(mesh.positions[triangle[2]] - a);
}

inline double TriangleArea(const IndexedMesh& mesh,
                           const std::array<uint32_t, 3>& triangle) {
  return AreaNormal(mesh, triangle).norm() / 2;
}

}  // namespace octacut
