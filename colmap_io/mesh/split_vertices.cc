#include "colmap_io/mesh/split_vertices.h"

#include <unordered_map>

namespace octacut {

SplitVertices SplitPage(const TexturedMesh& mesh, uint32_t page) {
  SplitVertices split;
  std::unordered_map<uint64_t, uint32_t> numbers;
  for (uint32_t f = 0; f < mesh.mesh.triangles.size(); ++f) {
    if (mesh.PageOf(f) != page) {
      continue;
    }
    std::array<uint32_t, 3> triangle;
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t vertex = mesh.mesh.triangles[f][k];
      const uint64_t key = uint64_t{mesh.charts[f]} << 32 | vertex;
      const auto [place, is_new] =
          numbers.emplace(key, uint32_t(split.vertices.size()));
      if (is_new) {
        split.vertices.push_back(vertex);
        split.corners.push_back({f, k});
      }
      triangle[k] = place->second;
    }
    split.triangles.push_back(triangle);
  }
  return split;
}

}  // namespace octacut
