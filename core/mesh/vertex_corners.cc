#include "core/mesh/vertex_corners.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace octacut {

VertexCorners FindVertexCorners(
    size_t num_vertices, std::span<const std::array<uint32_t, 3>> triangles) {
  if (triangles.size() > 0xffffffffu / 3) {
    throw Error(
        fmt::format("a mesh of {} triangles is too large", triangles.size()));
  }
  VertexCorners result;
  result.offsets.assign(num_vertices + 1, 0);
  for (const std::array<uint32_t, 3>& triangle : triangles) {
    for (const uint32_t vertex : triangle) {
      ++result.offsets[vertex];
    }
  }
  // Each offset is first the end of its range, then counted down to its
  // begin.
  uint32_t end = 0;
  for (uint32_t& offset : result.offsets) {
    end += offset;
    offset = end;
  }
  result.entries.resize(end);
  for (size_t t = triangles.size(); t-- > 0;) {
    for (int i = 3; i-- > 0;) {
      result.entries[--result.offsets[triangles[t][i]]] = uint32_t(3 * t + i);
    }
  }
  return result;
}

VertexCorners FindVertexNeighbors(
    size_t num_vertices, std::span<const std::array<uint32_t, 3>> triangles) {
  VertexCorners result = FindVertexCorners(num_vertices, triangles);
  // Each neighbour follows the vertex in exactly one triangle.
  for (uint32_t& entry : result.entries) {
    entry = triangles[entry / 3][(entry + 1) % 3];
  }
  return result;
}

VertexCorners FindVertexFaces(
    size_t num_vertices, std::span<const std::array<uint32_t, 3>> triangles) {
  VertexCorners result = FindVertexCorners(num_vertices, triangles);
  for (uint32_t& entry : result.entries) {
    entry /= 3;
  }
  return result;
}

std::vector<uint8_t> Dilate(std::vector<uint8_t> set,
                            const VertexCorners& neighbors,
                            int rings) {
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<uint8_t> before = set;
    for (size_t v = 0; v < set.size(); ++v) {
      for (const uint32_t next : neighbors.Of(v)) {
        set[v] |= before[next];
      }
    }
  }
  return set;
}

}  // namespace octacut
