#include "core/refine/keep_valid.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/parallel.h"
#include "core/mesh/untangle.h"

namespace octacut {
namespace {

constexpr size_t kValidityGrain = 4096;
// The least height of a triangle, pixels.
constexpr double kMinHeight = 0.01;
// Averagings with the neighbours.
constexpr int kRelaxations = 5;
// Pixels out of a mask at which one point is as bad as another, and the steps
// to there: a twentieth of a pixel, and five per cent.
constexpr float kMaxReach = 200;
constexpr float kReachStep = 0.05f;
constexpr float kReachGrowth = 1.05f;

bool IsBackground(const PreparedView& view,
                  const Eigen::Vector3d& point,
                  float tolerance) {
  const std::optional<ProjectedPoint> p =
      view.projection.Project(point.cast<float>());
  return p &&
         view.silhouette.Test(p->u - tolerance,
                              p->v - tolerance,
                              p->u + tolerance,
                              p->v + tolerance) == Containment::kBackground;
}

// Whether a view shows the point farther out than `tolerance`, `start` and
// `before`.
bool LeavesHull(const ViewSet& views,
                const Eigen::Vector3d& start,
                const Eigen::Vector3d& before,
                const Eigen::Vector3d& point,
                float tolerance) {
  return std::any_of(views.begin(), views.end(), [&](const PreparedView& view) {
    for (float reach = tolerance;
         reach < kMaxReach && IsBackground(view, point, reach);
         reach = kReachGrowth * reach + kReachStep) {
      if (!IsBackground(view, start, reach) &&
          !IsBackground(view, before, reach)) {
        return true;
      }
    }
    return false;
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
  return size_t(ParallelSum(
      context, start.size(), kValidityGrain, [&](size_t begin, size_t end) {
        int64_t num_withdrawn = 0;
        for (size_t v = begin; v < end; ++v) {
          if (positions[v] == before[v]) {
            continue;
          }
          const Eigen::Vector3d way = positions[v] - before[v];
          size_t step = 0;
          while (
              step + 1 < kLeftOfWay.size() &&
              LeavesHull(
                  views, start[v], before[v], positions[v], float(tolerance))) {
            positions[v] = before[v] + kLeftOfWay[++step] * way;
          }
          num_withdrawn += step > 0 ? 1 : 0;
        }
        return num_withdrawn;
      }));
}

// Smooths where vertices are not where they were `wanted`, and a ring around:
// moved back one by one they stand out of a surface that has moved on, and with
// normals so odd that no view or point speaks of them any more. What was to
// stay where it was stays.
void RelaxMoved(const std::vector<Eigen::Vector3d>& before,
                const std::vector<Eigen::Vector3d>& wanted,
                const VertexCorners& neighbors,
                IndexedMesh* mesh) {
  std::vector<Eigen::Vector3d>& positions = mesh->positions;
  std::vector<uint8_t> is_held(wanted.size());
  for (size_t v = 0; v < wanted.size(); ++v) {
    is_held[v] = positions[v] != wanted[v] ? 1 : 0;
  }
  is_held = Dilate(std::move(is_held), neighbors, 1);
  std::vector<uint32_t> vertices;
  for (uint32_t v = 0; v < wanted.size(); ++v) {
    if (is_held[v] && wanted[v] != before[v]) {
      vertices.push_back(v);
    }
  }
  std::vector<Eigen::Vector3d> relaxed(vertices.size());
  for (int i = 0; i < kRelaxations; ++i) {
    for (size_t k = 0; k < vertices.size(); ++k) {
      const uint32_t v = vertices[k];
      relaxed[k] =
          0.5 * (positions[v] + MeanPosition(neighbors.Of(v), positions));
    }
    for (size_t k = 0; k < vertices.size(); ++k) {
      positions[vertices[k]] = relaxed[k];
    }
  }
}

}  // namespace

size_t KeepValid(const ViewSet& views,
                 const VertexCorners& neighbors,
                 const ValidMoves& moves,
                 const Context& context,
                 IndexedMesh* mesh) {
  const auto& [start, before, tolerance, pixel] = moves;
  const Phase phase(context, "refinement: validity check");
  const size_t num_withdrawn =
      WithdrawIntoHull(views, start, before, tolerance, context, mesh);
  const std::vector<Eigen::Vector3d> wanted = mesh->positions;
  const size_t num_tangled =
      Untangle(before, kMinHeight * pixel, context, mesh).num_withdrawn;
  if (num_tangled > 0) {
    const std::vector<Eigen::Vector3d> valid = mesh->positions;
    RelaxMoved(before, wanted, neighbors, mesh);
    WithdrawIntoHull(views, start, valid, tolerance, context, mesh);
    Untangle(valid, kMinHeight * pixel, context, mesh);
  }
  return num_withdrawn + num_tangled;
}

size_t KeepFloatsValid(const std::vector<Eigen::Vector3d>& before,
                       double pixel,
                       const Context& context,
                       IndexedMesh* mesh) {
  return UntangleFloats(before, kMinHeight * pixel, context, mesh)
      .num_withdrawn;
}

}  // namespace octacut
