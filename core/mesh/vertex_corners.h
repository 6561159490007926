// The triangles around each vertex, as one flat array.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace octacut {

// A corner of a triangle: 3 * triangle + position in it. Those of vertex v
// are corners[offsets[v]] .. corners[offsets[v + 1] - 1], ascending.
struct VertexCorners {
  std::vector<uint32_t> offsets;
  std::vector<uint32_t> corners;

  std::span<const uint32_t> Of(size_t vertex) const {
    return {corners.data() + offsets[vertex],
            corners.data() + offsets[vertex + 1]};
  }
};

// Indices must be below `num_vertices`.
VertexCorners FindVertexCorners(
    size_t num_vertices, std::span<const std::array<uint32_t, 3>> triangles);

// The same of a closed, oriented mesh with the neighbours of each vertex, each
// of them once, in place of the corners.
VertexCorners FindVertexNeighbors(
    size_t num_vertices, std::span<const std::array<uint32_t, 3>> triangles);

}  // namespace octacut
