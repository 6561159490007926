#include "core/benchmark/protocols/middlebury.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/benchmark/protocols/surface_points.h"
#include "core/mesh/audit.h"
#include "core/mesh/cloud.h"
#include "core/raycast/ray_scene.h"

namespace octacut {
namespace {

constexpr double kAccuracyFraction = 0.9;
constexpr size_t kMiddleburyGrain = 2048;

// Infinite for vertices that are closer to `filler`.
std::vector<double> MeasureVertices(const IndexedMesh& from,
                                    const IndexedMesh& to,
                                    const IndexedMesh* filler,
                                    const Context& context) {
  const std::vector<Eigen::Vector3d> points = UsedPoints(from);
  const RayScene surface(PointsAsTriangles(to));
  std::optional<RayScene> filled;
  if (filler != nullptr) {
    filled.emplace(*filler);
  }
  std::vector<double> distances(points.size());
  Phase phase(context, "distances (Middlebury)", points.size());
  ParallelFor(
      context, points.size(), kMiddleburyGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          distances[i] = surface.ClosestPoint(points[i]).distance;
          if (filled &&
              filled->ClosestPoint(points[i]).distance < distances[i]) {
            distances[i] = std::numeric_limits<double>::infinity();
          }
        }
        phase.Advance(end - begin);
      });
  return distances;
}

}  // namespace

bool NeedsHoleFiller(const IndexedMesh& reference, const Context& context) {
  return !reference.triangles.empty() &&
         AuditMesh(reference, context).num_boundary_edges > 0;
}

ProtocolResult MeasureMiddlebury(const IndexedMesh& mesh,
                                 const IndexedMesh& reference,
                                 const IndexedMesh* hole_filler,
                                 double tolerance,
                                 const Context& context) {
  std::vector<double> accuracy =
      MeasureVertices(mesh, reference, hole_filler, context);
  const size_t num_vertices = accuracy.size();
  std::erase_if(accuracy, [](double d) { return !std::isfinite(d); });
  if (accuracy.empty()) {
    throw InputError(
        "middlebury: all vertices of the mesh are closest to the surface that "
        "fills the holes of the ground truth");
  }
  const auto last =
      accuracy.begin() +
      static_cast<std::ptrdiff_t>(
          std::ceil(kAccuracyFraction * static_cast<double>(accuracy.size()))) -
      1;
  std::nth_element(accuracy.begin(), last, accuracy.end());
  const std::vector<double> back =
      MeasureVertices(reference, mesh, nullptr, context);
  const auto covered = std::count_if(
      back.begin(), back.end(), [&](double d) { return d <= tolerance; });
  ProtocolResult result;
  result.figures = {
      {"accuracy", *last},
      {"completeness",
       static_cast<double>(covered) / static_cast<double>(back.size()),
       FigureKind::kFraction},
      {"vertices", static_cast<double>(num_vertices), FigureKind::kCount},
      {"vertices at holes",
       static_cast<double>(num_vertices - accuracy.size()),
       FigureKind::kCount}};
  return result;
}

}  // namespace octacut
