#include "core/refine/spread_vertices.h"

namespace octacut {

std::vector<uint32_t> SpreadVertices(const IndexedMesh& mesh,
                                     const VertexCorners& neighbors,
                                     const std::vector<uint8_t>& eligible,
                                     double distance) {
  std::vector<uint32_t> chosen;
  std::vector<uint8_t> is_covered(mesh.positions.size());
  std::vector<uint32_t> found_by(mesh.positions.size(), 0xffffffffu);
  std::vector<uint32_t> found;
  for (uint32_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    if (!eligible[vertex] || is_covered[vertex]) {
      continue;
    }
    chosen.push_back(vertex);
    found.assign(1, vertex);
    found_by[vertex] = vertex;
    for (size_t i = 0; i < found.size(); ++i) {
      is_covered[found[i]] = 1;
      for (const uint32_t next : neighbors.Of(found[i])) {
        if (found_by[next] != vertex &&
            (mesh.positions[next] - mesh.positions[vertex]).squaredNorm() <=
                distance * distance) {
          found_by[next] = vertex;
          found.push_back(next);
        }
      }
    }
  }
  return chosen;
}

}  // namespace octacut
