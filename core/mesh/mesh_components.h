// Connected components of a triangle mesh.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace octacut {

struct MeshComponents {
  static constexpr uint32_t kNone = 0xffffffffu;
  size_t count = 0;
  // Component of every vertex; kNone for vertices without a triangle.
  // Components are numbered by their lowest vertex.
  std::vector<uint32_t> of_vertex;
};

// Connected through shared vertices. Indices must be below `num_vertices`.
MeshComponents FindComponents(
    size_t num_vertices, std::span<const std::array<uint32_t, 3>> triangles);

}  // namespace octacut
