#include "core/mesh/mesh_components.h"

#include "core/mesh/disjoint_sets.h"

namespace octacut {

MeshComponents FindComponents(
    size_t num_vertices, std::span<const std::array<uint32_t, 3>> triangles) {
  DisjointSets sets(num_vertices);
  std::vector<uint8_t> is_used(num_vertices);
  for (const std::array<uint32_t, 3>& triangle : triangles) {
    sets.Unite(triangle[0], triangle[1]);
    sets.Unite(triangle[1], triangle[2]);
    for (const uint32_t v : triangle) {
      is_used[v] = 1;
    }
  }
  MeshComponents result;
  result.of_vertex.assign(num_vertices, MeshComponents::kNone);
  for (uint32_t v = 0; v < num_vertices; ++v) {
    if (is_used[v]) {
      const uint32_t root = sets.Find(v);
      result.of_vertex[v] =
          root == v ? uint32_t(result.count++) : result.of_vertex[root];
    }
  }
  return result;
}

}  // namespace octacut
