#include "core/texture/face_neighbors.h"

#include <algorithm>

namespace octacut {
namespace {

struct EdgeOfFace {
  uint64_t key;  // both vertices, the smaller one first
  uint32_t face;
  uint32_t side;
};

uint64_t EdgeKey(uint32_t a, uint32_t b) {
  return uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

}  // namespace

std::vector<std::array<uint32_t, 3>> FindFaceNeighbors(
    const IndexedMesh& mesh) {
  std::vector<EdgeOfFace> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& corners = mesh.triangles[f];
    for (uint32_t k = 0; k < 3; ++k) {
      edges.push_back(
          {EdgeKey(corners[k], corners[(k + 1) % 3]), uint32_t(f), k});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) {
    return a.key != b.key ? a.key < b.key : a.face < b.face;
  });
  std::vector<std::array<uint32_t, 3>> neighbors(mesh.triangles.size(),
                                                 {kNoFace, kNoFace, kNoFace});
  for (size_t begin = 0; begin < edges.size();) {
    size_t end = begin + 1;
    while (end < edges.size() && edges[end].key == edges[begin].key) {
      ++end;
    }
    if (end == begin + 2) {
      const EdgeOfFace& a = edges[begin];
      const EdgeOfFace& b = edges[begin + 1];
      neighbors[a.face][a.side] = b.face;
      neighbors[b.face][b.side] = a.face;
    }
    begin = end;
  }
  return neighbors;
}

VertexFaces FindVertexFaces(const IndexedMesh& mesh) {
  VertexFaces result;
  result.first.assign(mesh.positions.size() + 1, 0);
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t corner : triangle) {
      ++result.first[corner + 1];
    }
  }
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    result.first[v + 1] += result.first[v];
  }
  std::vector<uint32_t> next(result.first.begin(), result.first.end() - 1);
  result.faces.resize(3 * mesh.triangles.size());
  for (size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (const uint32_t corner : mesh.triangles[f]) {
      result.faces[next[corner]++] = uint32_t(f);
    }
  }
  return result;
}

}  // namespace octacut
