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

}  // namespace octacut
