#include "core/refine/keep_valid.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/base/parallel.h"
#include "core/mesh/self_intersections.h"
#include "core/mesh/thin_triangles.h"

namespace octacut {
namespace {

constexpr size_t kGrain = 4096;
// What is left of the way at each step.
constexpr std::array<double, 4> kFractions = {1, 0.5, 0.25, 0};
// Of triangles, in pixels.
constexpr double kMinHeight = 0.01;

bool IsBackground(const PreparedView& view,
                  const Eigen::Vector3d& point,
                  float tolerance) {
  const Eigen::Vector3f h = view.projection.Homogeneous(point.cast<float>());
  if (!(h.z() > 0)) {
    return false;
  }
  const float u = h.x() / h.z();
  const float v = h.y() / h.z();
  return view.silhouette.Test(
             u - tolerance, v - tolerance, u + tolerance, v + tolerance) ==
         Footprint::kBackground;
}

bool LeavesHull(const ViewSet& views,
                const Eigen::Vector3d& start,
                const Eigen::Vector3d& point,
                float tolerance) {
  return std::any_of(views.begin(), views.end(), [&](const PreparedView& view) {
    return IsBackground(view, point, tolerance) &&
           !IsBackground(view, start, tolerance);
  });
}

// Returns how many were moved back.
size_t WithdrawIntoHull(const ViewSet& views,
                        const std::vector<Eigen::Vector3d>& start,
                        const std::vector<Eigen::Vector3d>& before,
                        double tolerance,
                        const Context& context,
                        IndexedMesh* mesh) {
  std::vector<Eigen::Vector3d>& positions = mesh->positions;
  std::vector<size_t> withdrawn(NumChunks(start.size(), kGrain));
  ParallelChunks(
      context,
      start.size(),
      kGrain,
      [&](size_t chunk, size_t begin, size_t end) {
        for (size_t v = begin; v < end; ++v) {
          if (positions[v] == before[v]) {
            continue;
          }
          const Eigen::Vector3d way = positions[v] - before[v];
          size_t step = 0;
          while (step + 1 < kFractions.size() &&
                 LeavesHull(views, start[v], positions[v], float(tolerance))) {
            positions[v] = before[v] + kFractions[++step] * way;
          }
          withdrawn[chunk] += step > 0 ? 1 : 0;
        }
      });
  return std::accumulate(withdrawn.begin(), withdrawn.end(), size_t{0});
}

// Pairs of triangles that intersect, of which one at least has moved since the
// search before.
class NewIntersections {
 public:
  std::vector<std::array<uint32_t, 2>> Find(const IndexedMesh& mesh,
                                            const Context& context) {
    std::vector<uint8_t> has_moved(mesh.triangles.size(), 1);
    if (!before_.empty()) {
      for (size_t i = 0; i < has_moved.size(); ++i) {
        const auto& corners = mesh.triangles[i];
        has_moved[i] =
            std::any_of(corners.begin(), corners.end(), [&](uint32_t v) {
              return mesh.positions[v] != before_[v];
            });
      }
    }
    before_ = mesh.positions;
    return FindIntersectionsOfMarked(mesh, has_moved, context);
  }

 private:
  std::vector<Eigen::Vector3d> before_;
};

// Returns how many were moved back.
size_t WithdrawFromIntersections(const std::vector<Eigen::Vector3d>& start,
                                 const Context& context,
                                 NewIntersections* intersections,
                                 IndexedMesh* mesh) {
  const std::vector<Eigen::Vector3d> target = mesh->positions;
  std::vector<uint8_t> steps(start.size());
  size_t num_withdrawn = 0;
  while (true) {
    std::vector<uint32_t> vertices;
    for (const auto& pair : intersections->Find(*mesh, context)) {
      for (const uint32_t triangle : pair) {
        const auto& corners = mesh->triangles[triangle];
        vertices.insert(vertices.end(), corners.begin(), corners.end());
      }
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()),
                   vertices.end());
    // Those that are back at the start intersected there already; so pairs
    // without any other need not be looked at again.
    std::erase_if(vertices, [&](uint32_t v) {
      return steps[v] + 1u == kFractions.size() || target[v] == start[v];
    });
    if (vertices.empty()) {
      return num_withdrawn;
    }
    for (const uint32_t v : vertices) {
      num_withdrawn += steps[v] == 0 ? 1 : 0;
      mesh->positions[v] =
          start[v] + kFractions[++steps[v]] * (target[v] - start[v]);
    }
  }
}

}  // namespace

size_t KeepValid(const ViewSet& views,
                 const std::vector<Eigen::Vector3d>& start,
                 const std::vector<Eigen::Vector3d>& before,
                 double tolerance,
                 double pixel,
                 const Context& context,
                 IndexedMesh* mesh) {
  const Phase phase(context, "refined mesh kept valid");
  size_t num_withdrawn =
      WithdrawIntoHull(views, start, before, tolerance, context, mesh);
  NewIntersections intersections;
  size_t num_intersecting;
  do {
    num_withdrawn += WithdrawFromThinTriangles(mesh->triangles,
                                               before,
                                               kMinHeight * pixel,
                                               context,
                                               mesh->positions)
                         .num_withdrawn;
    num_intersecting =
        WithdrawFromIntersections(before, context, &intersections, mesh);
    num_withdrawn += num_intersecting;
    // What is moved back may be thin again, until all of it is at the start.
  } while (num_intersecting > 0);
  return num_withdrawn;
}

}  // namespace octacut
