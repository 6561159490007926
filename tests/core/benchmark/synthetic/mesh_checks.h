// Topology and measures of closed triangle meshes, for tests.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

// Every edge runs once in each direction.
inline bool IsClosedAndOriented(const IndexedMesh& mesh) {
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      if (++edges[{triangle[k], triangle[(k + 1) % 3]}] > 1) {
        return false;
      }
    }
  }
  for (const auto& [edge, count] : edges) {
    if (edges.count({edge.second, edge.first}) == 0) {
      return false;
    }
  }
  return true;
}

inline int CountComponents(const IndexedMesh& mesh) {
  std::vector<uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](uint32_t v) {
    while (parent[v] != v) {
      v = parent[v] = parent[parent[v]];
    }
    return v;
  };
  for (const auto& triangle : mesh.triangles) {
    parent[root(triangle[0])] = root(triangle[1]);
    parent[root(triangle[1])] = root(triangle[2]);
  }
  int count = 0;
  for (uint32_t v = 0; v < parent.size(); ++v) {
    count += root(v) == v;
  }
  return count;
}

// Summed over the components of a closed mesh.
inline int Genus(const IndexedMesh& mesh) {
  const auto euler = static_cast<long>(mesh.positions.size()) -
                     static_cast<long>(mesh.triangles.size() / 2);
  return CountComponents(mesh) - static_cast<int>(euler / 2);
}

inline double Volume(const IndexedMesh& mesh) {
  double volume = 0;
  for (const auto& triangle : mesh.triangles) {
    volume += mesh.positions[triangle[0]].dot(mesh.positions[triangle[1]].cross(
                  mesh.positions[triangle[2]])) /
              6;
  }
  return volume;
}

inline double Area(const IndexedMesh& mesh) {
  double area = 0;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.positions[triangle[0]];
    area += (mesh.positions[triangle[1]] - a)
                .cross(mesh.positions[triangle[2]] - a)
                .norm() /
            2;
  }
  return area;
}

}  // namespace octacut
