#include "core/benchmark/compare/compare_meshes.h"

#include <cmath>
#include <Eigen/Geometry>
#include <iterator>
#include <limits>

#include "core/base/check_option.h"
#include "core/base/parallel.h"
#include "core/benchmark/compare/distance_curve.h"
#include "core/mesh/bounding_box.h"
#include "core/mesh/cloud.h"
#include "core/mesh/surface_samples.h"
#include "core/raycast/ray_scene.h"

namespace octacut {
namespace {

constexpr size_t kSampleGrain = 2048;
constexpr uint32_t kNoTriangle = std::numeric_limits<uint32_t>::max();

// Distances from one surface to the other, at the points that count.
struct Distances {
  std::vector<double> samples;
  size_t num_taken = 0;  // samples, those that do not count too
  double max = 0;
  // The errors by confidence of the first surface, if it has a confidence.
  std::optional<ConfidenceErrors> confidence;
};

// A triangle of each vertex; none of those that no triangle uses.
std::vector<SurfaceSample> UsedVertices(const IndexedMesh& mesh) {
  std::vector<uint32_t> triangle_of(mesh.positions.size(), kNoTriangle);
  for (size_t i = mesh.triangles.size(); i-- > 0;) {
    for (const uint32_t vertex : mesh.triangles[i]) {
      triangle_of[vertex] = static_cast<uint32_t>(i);
    }
  }
  std::vector<SurfaceSample> vertices;
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    if (triangle_of[i] != kNoTriangle) {
      vertices.push_back({mesh.positions[i], triangle_of[i]});
    }
  }
  return vertices;
}

// Which of the two surfaces the filter is about.
enum class Direction { kToReference, kFromReference };

class Measurement {
 public:
  Measurement(const CompareMeshesOptions& options, const Context& context)
      : options_(options), context_(context) {}

  // Not a number for points that do not count.
  std::vector<double> Measure(const std::vector<SurfaceSample>& points,
                              const RayScene& other,
                              Direction direction) const {
    const ReferenceFilter& filter = options_.reference_filter;
    std::vector<double> distances(points.size());
    Phase phase(context_,
                direction == Direction::kToReference
                    ? "distances to the reference"
                    : "distances from the reference",
                points.size());
    ParallelFor(
        context_, points.size(), kSampleGrain, [&](size_t begin, size_t end) {
          for (size_t i = begin; i < end; ++i) {
            const SurfaceSample& point = points[i];
            bool counts = !filter || direction == Direction::kToReference ||
                          filter(point.triangle, point.point);
            if (counts) {
              const RayScene::Closest closest = other.ClosestPoint(point.point);
              distances[i] = closest.distance;
              counts = !filter || direction == Direction::kFromReference ||
                       filter(closest.triangle, closest.point);
            }
            if (!counts) {
              distances[i] = std::numeric_limits<double>::quiet_NaN();
            }
          }
          phase.Advance(end - begin);
        });
    return distances;
  }

  Distances Run(const IndexedMesh& mesh,
                const RayScene& other,
                Direction direction,
                uint64_t seed) const {
    const auto num_wanted = static_cast<size_t>(options_.num_samples);
    std::vector<SurfaceSample> points =
        IsCloud(mesh) ? SampleCloud(mesh, num_wanted)
                      : SampleSurface(mesh, num_wanted, seed, context_);
    const auto num_samples = static_cast<std::ptrdiff_t>(points.size());
    const std::vector<SurfaceSample> samples = points;
    const std::vector<SurfaceSample> vertices = UsedVertices(mesh);
    points.insert(points.end(), vertices.begin(), vertices.end());
    const std::vector<double> distances = Measure(points, other, direction);
    Distances result;
    result.num_taken = samples.size();
    for (const double distance : distances) {
      // Not a number is larger than nothing.
      result.max = distance > result.max ? distance : result.max;
    }
    std::copy_if(distances.begin(),
                 distances.begin() + num_samples,
                 std::back_inserter(result.samples),
                 [](double distance) { return !std::isnan(distance); });
    if (!mesh.confidence.empty() && !IsCloud(mesh)) {
      result.confidence = MeasureConfidenceErrors(mesh, samples, distances);
    }
    if (result.samples.empty()) {
      throw InputError(
          "comparison: no part of the reference is selected; check views_path "
          "and bounding_box");
    }
    return result;
  }

 private:
  const CompareMeshesOptions& options_;
  const Context& context_;
};

// The smallest value that at least `fraction` of `sorted` does not exceed.
double Quantile(const std::vector<double>& sorted, double fraction) {
  const double rank = std::ceil(fraction * static_cast<double>(sorted.size()));
  const size_t index = static_cast<size_t>(std::max(rank, 1.0)) - 1;
  return sorted[std::min(index, sorted.size() - 1)];
}

double FractionWithin(const std::vector<double>& sorted, double distance) {
  const auto end = std::upper_bound(sorted.begin(), sorted.end(), distance);
  return static_cast<double>(end - sorted.begin()) /
         static_cast<double>(sorted.size());
}

// Sorts the samples.
DistanceStatistics Summarize(Distances* distances) {
  std::vector<double>& samples = distances->samples;
  std::sort(samples.begin(), samples.end());
  double sum = 0;
  double sum_of_squares = 0;
  for (const double distance : samples) {
    sum += distance;
    sum_of_squares += distance * distance;
  }
  const auto count = static_cast<double>(samples.size());
  DistanceStatistics statistics;
  statistics.num_samples = samples.size();
  statistics.mean = sum / count;
  statistics.rms = std::sqrt(sum_of_squares / count);
  statistics.median = Quantile(samples, 0.5);
  statistics.percentile_90 = Quantile(samples, 0.9);
  statistics.max = distances->max;
  return statistics;
}

void Score(const Distances& to_reference,
           const Distances& from_reference,
           const CompareMeshesOptions& options,
           MeshComparison* result) {
  for (const double threshold : options.thresholds) {
    ThresholdScore score;
    score.threshold = threshold;
    score.distance = threshold * result->reference_diagonal;
    score.precision = FractionWithin(to_reference.samples, score.distance);
    score.recall = FractionWithin(from_reference.samples, score.distance);
    const double sum = score.precision + score.recall;
    score.f_score = sum > 0 ? 2 * score.precision * score.recall / sum : 0;
    result->scores.push_back(score);
  }
  result->precision_curve =
      DistanceCurve(to_reference.samples, result->reference_diagonal);
  result->recall_curve =
      DistanceCurve(from_reference.samples, result->reference_diagonal);
  result->accuracy = Quantile(to_reference.samples, options.accuracy_fraction);
  result->completeness = FractionWithin(
      from_reference.samples,
      options.completeness_threshold * result->reference_diagonal);
}

void CheckComparable(const IndexedMesh& mesh, const char* which) {
  if (mesh.positions.empty()) {
    throw InputError(
        fmt::format("{}: there are neither triangles nor points", which));
  }
}

}  // namespace

void CompareMeshesOptions::Check() const {
  CheckOption(num_samples >= 10 && num_samples <= int64_t{1'000'000'000},
              "num_samples",
              num_samples,
              "must be from 10 to 1000000000");
  CheckOption(!thresholds.empty(),
              "thresholds",
              "",
              "must name at least one fraction of the diagonal");
  for (const double threshold : thresholds) {
    CheckOption(threshold > 0 && threshold < 1,
                "thresholds",
                threshold,
                "must be fractions of the diagonal, in (0, 1)");
  }
  CheckOption(accuracy_fraction > 0 && accuracy_fraction <= 1,
              "accuracy_fraction",
              accuracy_fraction,
              "must be in (0, 1]");
  CheckOption(completeness_threshold > 0 && completeness_threshold < 1,
              "completeness_threshold",
              completeness_threshold,
              "must be a fraction of the diagonal, in (0, 1)");
  if (align) {
    alignment.Check();
  }
}

MeshComparison CompareMeshes(const IndexedMesh& mesh,
                             const IndexedMesh& reference,
                             const CompareMeshesOptions& options,
                             const Context& context) {
  options.Check();
  CheckComparable(mesh, "mesh to compare");
  CheckComparable(reference, "reference");
  if (mesh.triangles.empty() || reference.triangles.empty()) {
    return CompareMeshes(PointsAsTriangles(mesh),
                         PointsAsTriangles(reference),
                         options,
                         context);
  }
  const RayScene reference_scene(reference);
  RayScene mesh_scene(mesh);
  MeshComparison result;
  result.reference_diagonal = BoxOfTriangles(reference).diagonal().norm();
  IndexedMesh moved;
  if (options.align) {
    result.alignment = AlignMeshes({mesh, mesh_scene},
                                   {reference, reference_scene},
                                   options.alignment,
                                   context,
                                   options.reference_filter);
    moved = TransformMesh(mesh, result.alignment->reference_from_mesh);
    mesh_scene = RayScene(moved);
  }
  const IndexedMesh& aligned = options.align ? moved : mesh;
  const Measurement measurement(options, context);
  Distances to_reference = measurement.Run(
      aligned, reference_scene, Direction::kToReference, context.Seed());
  Distances from_reference = measurement.Run(
      reference, mesh_scene, Direction::kFromReference, context.Seed() + 1);
  result.to_reference = Summarize(&to_reference);
  result.from_reference = Summarize(&from_reference);
  result.confidence = to_reference.confidence;
  result.judged_share = static_cast<double>(result.from_reference.num_samples) /
                        static_cast<double>(from_reference.num_taken);
  Score(to_reference, from_reference, options, &result);
  return result;
}

}  // namespace octacut
