#include "core/mesh/mesh_components.h"

#include <algorithm>

namespace octacut {
namespace {

// Union-find in which the root of a set is its lowest vertex.
class VertexSets {
 public:
  explicit VertexSets(size_t size) : parents_(size, MeshComponents::kNone) {}

  uint32_t Root(uint32_t v) {
    if (parents_[v] == MeshComponents::kNone) {
      parents_[v] = v;
    }
    while (parents_[v] != v) {
      v = parents_[v] = parents_[parents_[v]];
    }
    return v;
  }
  void Join(uint32_t v, uint32_t w) {
    const uint32_t a = Root(v);
    const uint32_t b = Root(w);
    parents_[std::max(a, b)] = std::min(a, b);
  }
  bool IsUsed(uint32_t v) const { return parents_[v] != MeshComponents::kNone; }

 private:
  std::vector<uint32_t> parents_;
};

}  // namespace

MeshComponents FindComponents(
    size_t num_vertices, std::span<const std::array<uint32_t, 3>> triangles) {
  VertexSets sets(num_vertices);
  for (const std::array<uint32_t, 3>& triangle : triangles) {
    sets.Join(triangle[0], triangle[1]);
    sets.Join(triangle[1], triangle[2]);
  }
  MeshComponents result;
  result.of_vertex.assign(num_vertices, MeshComponents::kNone);
  for (uint32_t v = 0; v < num_vertices; ++v) {
    if (sets.IsUsed(v)) {
      const uint32_t root = sets.Root(v);
      result.of_vertex[v] =
          root == v ? uint32_t(result.count++) : result.of_vertex[root];
    }
  }
  return result;
}

}  // namespace octacut
