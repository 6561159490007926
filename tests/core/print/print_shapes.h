// Shapes whose volume, area and walls are known.
#pragma once

#include <cmath>
#include <numbers>

#include "tests/core/mesh/test_shapes.h"

namespace octacut {

// Around the z-axis; `n` corners around it and around the tube.
inline IndexedMesh Torus(uint32_t n, double ring, double tube) {
  IndexedMesh mesh;
  const double step = 2 * std::numbers::pi / n;
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t j = 0; j < n; ++j) {
      const double radius = ring + tube * std::cos(j * step);
      mesh.positions.emplace_back(radius * std::cos(i * step),
                                  radius * std::sin(i * step),
                                  tube * std::sin(j * step));
      const uint32_t i_next = (i + 1) % n;
      const uint32_t j_next = (j + 1) % n;
      const uint32_t a = i * n + j;
      const uint32_t b = i_next * n + j;
      const uint32_t c = i_next * n + j_next;
      const uint32_t d = i * n + j_next;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

inline IndexedMesh InsideOut(IndexedMesh mesh) {
  for (auto& triangle : mesh.triangles) {
    std::swap(triangle[0], triangle[1]);
  }
  return mesh;
}

// The unit cube with a cubic cavity that leaves walls of that thickness.
inline IndexedMesh BoxWithWall(uint32_t n, double wall) {
  IndexedMesh cavity = InsideOut(Cube(n));
  for (Eigen::Vector3d& position : cavity.positions) {
    position = Eigen::Vector3d::Constant(wall) + (1 - 2 * wall) * position;
  }
  return Joined(Cube(n), cavity);
}

}  // namespace octacut
