// Triangle soups for tests.
#pragma once

#include <random>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

inline Eigen::Vector3d RandomPoint(std::mt19937& rng, double extent) {
  std::uniform_real_distribution<double> uniform(-extent, extent);
  const double x = uniform(rng);
  const double y = uniform(rng);
  return {x, y, uniform(rng)};
}

// `count` triangles of about `size` around `center`, in a cube of half edge
// `extent`.
inline IndexedMesh RandomSoup(std::mt19937& rng,
                              size_t count,
                              const Eigen::Vector3d& center,
                              double extent,
                              double size) {
  IndexedMesh mesh;
  for (size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d corner = center + RandomPoint(rng, extent);
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (int k = 0; k < 3; ++k) {
      mesh.positions.push_back(corner + RandomPoint(rng, size));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

}  // namespace octacut
