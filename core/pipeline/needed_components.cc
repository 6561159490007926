#include "core/pipeline/needed_components.h"

#include <algorithm>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/mesh/mesh_components.h"
#include "core/raycast/ray_scene.h"
#include "core/raycast/unit_mesh.h"

namespace octacut {
namespace {

constexpr double kNeededShare = 1e-3;  // of a view's object pixels
constexpr int kWitnesses = 2;          // views
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<IndexedMesh> Split(const IndexedMesh& mesh) {
  const MeshComponents components =
      FindComponents(mesh.positions.size(), mesh.triangles);
  std::vector<IndexedMesh> parts(components.count);
  std::vector<uint32_t> index(mesh.positions.size());
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    if (components.of_vertex[v] != MeshComponents::kNone) {
      IndexedMesh& part = parts[components.of_vertex[v]];
      index[v] = uint32_t(part.positions.size());
      part.positions.push_back(mesh.positions[v]);
    }
  }
  for (const std::array<uint32_t, 3>& t : mesh.triangles) {
    parts[components.of_vertex[t[0]]].triangles.push_back(
        {index[t[0]], index[t[1]], index[t[2]]});
  }
  return parts;
}

void Append(const IndexedMesh& part, IndexedMesh* mesh) {
  const auto first = uint32_t(mesh->positions.size());
  mesh->positions.insert(
      mesh->positions.end(), part.positions.begin(), part.positions.end());
  for (const std::array<uint32_t, 3>& t : part.triangles) {
    mesh->triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

// Pixels of the frame that the mesh (unit coordinates) can cover; all where a
// vertex is not before the camera.
Eigen::AlignedBox2i PixelsAround(const ViewProjection& projection,
                                 const IndexedMesh& mesh) {
  const Eigen::AlignedBox2i frame(
      Eigen::Vector2i::Zero(),
      Eigen::Vector2i(projection.width - 1, projection.height - 1));
  Eigen::AlignedBox2f box;
  for (const Eigen::Vector3d& position : mesh.positions) {
    const std::optional<ProjectedPoint> p =
        projection.Project(position.cast<float>());
    if (!p) {
      return frame;
    }
    box.extend(Eigen::Vector2f(p->u, p->v));
  }
  // The frame ends a pixel behind its last ones.
  const Eigen::Vector2f end =
      (frame.max() + Eigen::Vector2i::Ones()).cast<float>();
  const Eigen::AlignedBox2f seen =
      box.intersection(Eigen::AlignedBox2f(Eigen::Vector2f::Zero(), end));
  return seen.isEmpty() ? Eigen::AlignedBox2i()
                        : Eigen::AlignedBox2i(
                              seen.min().cast<int>().cwiseMin(frame.max()),
                              seen.max().cast<int>().cwiseMin(frame.max()));
}

// Whether a part covers enough of one view that the rest does not.
bool IsNeededIn(const PreparedView& view,
                const IndexedMesh& part,
                const RayScene& part_rays,
                const RayScene& rest) {
  const Eigen::AlignedBox2i box = PixelsAround(view.projection, part);
  const double least =
      std::max(1.0, kNeededShare * double(view.silhouette.NumObjectPixels()));
  if (box.isEmpty() ||
      double(box.sizes().x() + 1) * double(box.sizes().y() + 1) < least) {
    return false;
  }
  const Eigen::Matrix3d unproject =
      view.projection.linear.cast<double>().inverse();
  const Eigen::Vector3d center = view.projection.center.cast<double>();
  double count = 0;
  for (int y = box.min().y(); y <= box.max().y(); ++y) {
    for (int x = box.min().x(); x <= box.max().x(); ++x) {
      const float u = float(x) + 0.5f;
      const float v = float(y) + 0.5f;
      const Eigen::Vector3d ray = unproject * Eigen::Vector3d(u, v, 1);
      count += view.silhouette.IsKnown(u, v) &&
               view.silhouette.SignedDistance(u, v) > view.SureDepth() &&
               part_rays.IsOccluded(center, ray, 0, kInfinity) &&
               !rest.IsOccluded(center, ray, 0, kInfinity);
    }
  }
  return count >= least;
}

}  // namespace

size_t RestoreNeededComponents(const ViewSet& views,
                               const BoundingCube& cube,
                               const Context& context,
                               KeptComponents* kept) {
  if (kept->removed.triangles.empty()) {
    return 0;
  }
  std::vector<IndexedMesh> parts = Split(kept->removed);
  std::stable_sort(parts.begin(),
                   parts.end(),
                   [](const IndexedMesh& a, const IndexedMesh& b) {
                     return a.triangles.size() > b.triangles.size();
                   });
  std::optional<RayScene> rest;  // of kept->mesh
  IndexedMesh removed;
  size_t num_restored = 0;
  for (const IndexedMesh& part : parts) {
    if (!rest) {
      rest.emplace(UnitMesh(kept->mesh, cube));
    }
    const IndexedMesh unit = UnitMesh(part, cube);
    const RayScene rays(unit);
    const int64_t witnesses =
        ParallelSum(context, views.size(), 1, [&](size_t begin, size_t end) {
          int64_t count = 0;
          for (size_t i = begin; i < end; ++i) {
            count += IsNeededIn(views[i], unit, rays, *rest);
          }
          return count;
        });
    const bool is_needed = witnesses >= kWitnesses;
    Append(part, is_needed ? &kept->mesh : &removed);
    if (is_needed) {
      ++num_restored;
      rest.reset();
    }
  }
  kept->removed = std::move(removed);
  kept->num_removed -= num_restored;
  return num_restored;
}

}  // namespace octacut
