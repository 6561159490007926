// Shapes whose areas and distances are known.
#pragma once

#include <cmath>
#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <utility>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

// A grid of n x n squares over [0, 1]^2 at the height of height(x, y), facing
// up where that is flat.
inline IndexedMesh HeightField(
    uint32_t n, const std::function<double(double, double)>& height) {
  IndexedMesh mesh;
  for (uint32_t row = 0; row <= n; ++row) {
    for (uint32_t column = 0; column <= n; ++column) {
      const double x = static_cast<double>(column) / n;
      const double y = static_cast<double>(row) / n;
      mesh.positions.emplace_back(x, y, height(x, y));
    }
  }
  for (uint32_t row = 0; row < n; ++row) {
    for (uint32_t column = 0; column < n; ++column) {
      const uint32_t a = row * (n + 1) + column;
      mesh.triangles.push_back({a, a + 1, a + n + 2});
      mesh.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  }
  return mesh;
}

// The surface of [0, 1]^3, every face of n x n squares; closed.
inline IndexedMesh Cube(uint32_t n) {
  IndexedMesh mesh;
  std::map<std::array<uint32_t, 3>, uint32_t> index_of;
  const auto vertex = [&](const std::array<uint32_t, 3>& key) {
    const auto [found, is_new] =
        index_of.emplace(key, static_cast<uint32_t>(mesh.positions.size()));
    if (is_new) {
      mesh.positions.push_back(Eigen::Vector3d(key[0], key[1], key[2]) /
                               static_cast<double>(n));
    }
    return found->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const uint32_t side : {0u, n}) {
      for (uint32_t u = 0; u < n; ++u) {
        for (uint32_t v = 0; v < n; ++v) {
          const auto corner = [&](uint32_t du, uint32_t dv) {
            std::array<uint32_t, 3> key;
            key[axis] = side;
            key[(axis + 1) % 3] = u + du;
            key[(axis + 2) % 3] = v + dv;
            return vertex(key);
          };
          const uint32_t a = corner(0, 0);
          uint32_t b = corner(1, 0);
          const uint32_t c = corner(1, 1);
          uint32_t d = corner(0, 1);
          if (side == 0) {
            std::swap(b, d);
          }
          mesh.triangles.push_back({a, b, c});
          mesh.triangles.push_back({a, c, d});
        }
      }
    }
  }
  return mesh;
}

// A cube blown up to the unit sphere, then moved by `place`.
inline IndexedMesh Sphere(
    uint32_t n,
    const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& place) {
  IndexedMesh mesh = Cube(n);
  for (Eigen::Vector3d& position : mesh.positions) {
    position =
        place((position - Eigen::Vector3d::Constant(0.5)).normalized().eval());
  }
  return mesh;
}

inline IndexedMesh Sphere(uint32_t n, double radius = 1) {
  return Sphere(n, [=](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return radius * p;
  });
}

// A potato without any symmetry.
inline IndexedMesh Potato(uint32_t n) {
  return Sphere(n, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    const double radius = 1 + 0.2 * std::sin(3 * p.x() + 1) +
                          0.15 * std::cos(4 * p.y() - p.z()) +
                          0.1 * p.z() * p.x();
    return radius * p.cwiseProduct(Eigen::Vector3d(1.3, 1, 0.8));
  });
}

// The triangles whose centre passes.
inline IndexedMesh KeepTriangles(
    IndexedMesh mesh, const std::function<bool(const Eigen::Vector3d&)>& keep) {
  std::erase_if(mesh.triangles, [&](const std::array<uint32_t, 3>& t) {
    return !keep(
        (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) /
        3);
  });
  return mesh;
}

inline IndexedMesh Joined(IndexedMesh first, const IndexedMesh& second) {
  const auto shift = static_cast<uint32_t>(first.positions.size());
  first.positions.insert(
      first.positions.end(), second.positions.begin(), second.positions.end());
  for (const auto& [a, b, c] : second.triangles) {
    first.triangles.push_back({a + shift, b + shift, c + shift});
  }
  return first;
}

inline IndexedMesh Moved(IndexedMesh mesh, const Eigen::Vector3d& shift) {
  for (Eigen::Vector3d& position : mesh.positions) {
    position += shift;
  }
  return mesh;
}

}  // namespace octacut
