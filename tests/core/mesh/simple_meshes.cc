#include "tests/core/mesh/simple_meshes.h"

#include <utility>

namespace octacut {

IndexedMesh MakeTetrahedron() {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  return mesh;
}

IndexedMesh MakeBox() {
  IndexedMesh mesh;
  for (int k = 0; k < 8; ++k) {
    mesh.positions.emplace_back(k & 1, k >> 1 & 1, k >> 2 & 1);
  }
  const std::array<std::array<uint32_t, 4>, 6> quads = {{{0, 4, 6, 2},
                                                         {1, 3, 7, 5},
                                                         {0, 1, 5, 4},
                                                         {2, 6, 7, 3},
                                                         {0, 2, 3, 1},
                                                         {4, 5, 7, 6}}};
  for (const auto& quad : quads) {
    mesh.triangles.push_back({quad[0], quad[1], quad[2]});
    mesh.triangles.push_back({quad[0], quad[2], quad[3]});
  }
  return mesh;
}

IndexedMesh MakeOctahedron() {
  IndexedMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    mesh.positions.push_back(-Eigen::Vector3d::Unit(axis));
    mesh.positions.push_back(Eigen::Vector3d::Unit(axis));
  }
  for (uint32_t octant = 0; octant < 8; ++octant) {
    const uint32_t x = octant & 1;
    const uint32_t y = 2 + (octant >> 1 & 1);
    const uint32_t z = 4 + (octant >> 2 & 1);
    const bool even = (x + y + z) % 2 == 1;
    mesh.triangles.push_back(even ? std::array<uint32_t, 3>{x, y, z}
                                  : std::array<uint32_t, 3>{x, z, y});
  }
  return mesh;
}

IndexedMesh Combine(const IndexedMesh& a,
                    const IndexedMesh& b,
                    const Eigen::Vector3d& move_b) {
  IndexedMesh mesh = a;
  const uint32_t first = uint32_t(a.positions.size());
  for (const Eigen::Vector3d& position : b.positions) {
    mesh.positions.push_back(position + move_b);
  }
  for (std::array<uint32_t, 3> triangle : b.triangles) {
    for (uint32_t& vertex : triangle) {
      vertex += first;
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

IndexedMesh TurnInsideOut(IndexedMesh mesh) {
  for (std::array<uint32_t, 3>& triangle : mesh.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

}  // namespace octacut
