#pragma once

#include <algorithm>
#include <cstddef>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

// The mean length of the sides of all triangles, in the unit of the mesh; 0
// without triangles.
inline double MeanEdge(const IndexedMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += (mesh.positions[b] - mesh.positions[a]).norm() +
           (mesh.positions[c] - mesh.positions[b]).norm() +
           (mesh.positions[a] - mesh.positions[c]).norm();
  }
  return sum / (3.0 * double(std::max<size_t>(mesh.triangles.size(), 1)));
}

}  // namespace octacut
