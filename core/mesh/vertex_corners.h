// The triangles around each vertex, as one flat array.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <span>
#include <vector>

namespace octacut {

// A corner of a triangle: 3 * triangle + position in it. Those of vertex v
// are entries[offsets[v]] .. entries[offsets[v + 1] - 1], ascending.
struct VertexCorners {
  std::vector<uint32_t> offsets;
  std::vector<uint32_t> entries;

  std::span<const uint32_t> Of(size_t vertex) const {
    return {entries.data() + offsets[vertex],
            entries.data() + offsets[vertex + 1]};
  }
};

// Indices must be below `num_vertices`.
VertexCorners FindVertexCorners(
    size_t num_vertices, std::span<const std::array<uint32_t, 3>> triangles);

// The same of a closed, oriented mesh with the neighbours of each vertex, each
// of them once, in place of the corners.
VertexCorners FindVertexNeighbors(
    size_t num_vertices, std::span<const std::array<uint32_t, 3>> triangles);

// The same with the triangles in place of the corners.
VertexCorners FindVertexFaces(
    size_t num_vertices, std::span<const std::array<uint32_t, 3>> triangles);

// The vertices of `set` (1: in it) and so many rings of `neighbors` around.
std::vector<uint8_t> Dilate(std::vector<uint8_t> set,
                            const VertexCorners& neighbors,
                            int rings);

// Mean position of `vertices`, at least one.
inline Eigen::Vector3d MeanPosition(
    std::span<const uint32_t> vertices,
    const std::vector<Eigen::Vector3d>& positions) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const uint32_t vertex : vertices) {
    sum += positions[vertex];
  }
  return sum / double(vertices.size());
}

}  // namespace octacut
