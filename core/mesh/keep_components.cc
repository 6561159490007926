#include "core/mesh/keep_components.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "core/base/check_option.h"
#include "core/mesh/mesh_components.h"

namespace octacut {
namespace {

// Signed volume of each component, from a point near it.
std::vector<double> Volumes(const IndexedMesh& mesh,
                            const MeshComponents& components) {
  std::vector<double> volumes(components.count, 0);
  std::vector<const Eigen::Vector3d*> origins(components.count, nullptr);
  for (const std::array<uint32_t, 3>& triangle : mesh.triangles) {
    const uint32_t component = components.of_vertex[triangle[0]];
    if (origins[component] == nullptr) {
      origins[component] = &mesh.positions[triangle[0]];
    }
    const Eigen::Vector3d& origin = *origins[component];
    const Eigen::Vector3d a = mesh.positions[triangle[0]] - origin;
    const Eigen::Vector3d b = mesh.positions[triangle[1]] - origin;
    const Eigen::Vector3d c = mesh.positions[triangle[2]] - origin;
    volumes[component] += a.dot(b.cross(c)) / 6;
  }
  return volumes;
}

// Removes all vertices of `mesh` for which `keep` is 0, and their triangles.
void Compact(const std::vector<uint8_t>& keep, IndexedMesh& mesh) {
  std::vector<uint32_t> index(mesh.positions.size(), 0);
  uint32_t next = 0;
  for (size_t v = 0; v < index.size(); ++v) {
    if (!keep[v]) {
      continue;
    }
    mesh.positions[next] = mesh.positions[v];
    index[v] = next++;
  }
  mesh.positions.resize(next);
  std::erase_if(mesh.triangles, [&](std::array<uint32_t, 3>& triangle) {
    if (!keep[triangle[0]]) {
      return true;
    }
    for (uint32_t& vertex : triangle) {
      vertex = index[vertex];
    }
    return false;
  });
}

}  // namespace

KeptComponents KeepLargestComponents(IndexedMesh mesh, double min_fraction) {
  CheckOption(min_fraction >= 0 && min_fraction <= 1,
              "min_fraction",
              min_fraction,
              "must be in [0, 1]");
  KeptComponents result;
  const MeshComponents components =
      FindComponents(mesh.positions.size(), mesh.triangles);
  const std::vector<double> volumes = Volumes(mesh, components);
  const auto largest =
      std::max_element(volumes.begin(), volumes.end(), [](double a, double b) {
        return std::abs(a) < std::abs(b);
      });
  std::vector<uint8_t> keep(components.count);
  for (size_t c = 0; c < components.count; ++c) {
    keep[c] = std::abs(volumes[c]) >= min_fraction * std::abs(*largest) &&
              (min_fraction < 1 || c == size_t(largest - volumes.begin()));
    result.num_removed += !keep[c];
  }
  if (result.num_removed > 0) {
    std::vector<uint8_t> keep_vertex(mesh.positions.size());
    std::vector<uint8_t> is_removed(mesh.positions.size());
    for (size_t v = 0; v < keep_vertex.size(); ++v) {
      const uint32_t component = components.of_vertex[v];
      keep_vertex[v] =
          component == MeshComponents::kNone || keep[component] != 0;
      is_removed[v] = !keep_vertex[v] && volumes[component] > 0;
    }
    result.removed = mesh;
    Compact(is_removed, result.removed);
    Compact(keep_vertex, mesh);
  }
  result.mesh = std::move(mesh);
  return result;
}

}  // namespace octacut
