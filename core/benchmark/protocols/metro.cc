#include "core/benchmark/protocols/metro.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"
#include "core/benchmark/protocols/surface_points.h"
#include "core/mesh/cloud.h"
#include "core/mesh/surface_samples.h"
#include "core/raycast/ray_scene.h"

namespace octacut {
namespace {

constexpr size_t kSamplesPerTriangle = 10;
// So many samples at once: of large meshes they would take gigabytes.
constexpr size_t kBatch = 1'000'000;
constexpr size_t kMetroGrain = 2048;

struct Side {
  double sum = 0;
  double sum_of_squares = 0;
  double max = 0;
  size_t num_samples = 0;

  double Mean() const { return sum / static_cast<double>(num_samples); }
  double Rms() const {
    return std::sqrt(sum_of_squares / static_cast<double>(num_samples));
  }
};

std::vector<double> DistancesTo(const RayScene& surface,
                                const std::vector<Eigen::Vector3d>& points,
                                const Context& context) {
  std::vector<double> distances(points.size());
  ParallelEach(context, points.size(), kMetroGrain, [&](size_t i) {
    distances[i] = surface.ClosestPoint(points[i]).distance;
  });
  return distances;
}

void AddSamples(const std::vector<double>& distances, Side* side) {
  for (const double distance : distances) {
    side->sum += distance;
    side->sum_of_squares += distance * distance;
    side->max = std::max(side->max, distance);
  }
  side->num_samples += distances.size();
}

Side MeasureSide(const IndexedMesh& from,
                 const RayScene& to,
                 size_t num_samples,
                 const Context& context) {
  Side side;
  const std::vector<double> at_vertices =
      DistancesTo(to, UsedPoints(from), context);
  if (from.triangles.empty()) {
    AddSamples(at_vertices, &side);
    return side;
  }
  side.max = *std::max_element(at_vertices.begin(), at_vertices.end());
  Phase phase(context, "distances (Metro)", num_samples);
  for (size_t done = 0, batch = 0; done < num_samples; ++batch) {
    const size_t count = std::min(kBatch, num_samples - done);
    std::vector<Eigen::Vector3d> points;
    points.reserve(count);
    for (const SurfaceSample& sample :
         SampleSurface(from, count, context.Seed() + batch, context)) {
      points.push_back(sample.point);
    }
    AddSamples(DistancesTo(to, points, context), &side);
    done += count;
    phase.Advance(count);
  }
  return side;
}

}  // namespace

ProtocolResult MeasureMetro(const IndexedMesh& mesh,
                            const IndexedMesh& reference,
                            const Context& context) {
  const size_t num_samples =
      kSamplesPerTriangle *
      std::max(mesh.triangles.size(), reference.triangles.size());
  const Side forward = MeasureSide(
      mesh, RayScene(PointsAsTriangles(reference)), num_samples, context);
  const Side backward = MeasureSide(
      reference, RayScene(PointsAsTriangles(mesh)), num_samples, context);
  ProtocolResult result;
  result.figures = {
      {"forward mean", forward.Mean()},
      {"forward rms", forward.Rms()},
      {"forward max", forward.max},
      {"backward mean", backward.Mean()},
      {"backward rms", backward.Rms()},
      {"backward max", backward.max},
      {"Hausdorff", std::max(forward.max, backward.max)},
      {"samples",
       static_cast<double>(forward.num_samples + backward.num_samples),
       FigureKind::kCount}};
  return result;
}

}  // namespace octacut
