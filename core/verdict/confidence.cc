#include "core/verdict/confidence.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/verdict/surface_support.h"

namespace octacut {
namespace {

constexpr size_t kConfidenceGrain = 4096;
// Rings of points over which it is asked whether photographs decide: where they
// seldom do, agreement is chance.
constexpr int kRegionRings = 3;
// What the views' agreement leaves open even where it is rarest, in the errors
// of points where it is the rule.
constexpr float kMinRegion = 0.05f;
// Pixels. A visual hull touches the object along the occluding contours of the
// views alone and lies outside of it between them: it is the closer the more
// occluding contours are near. Measured on polished bronze
// (docs/experiments/verdict.md).
constexpr float kContourError = 0.4f;
constexpr float kBetweenContours = 3;
// Times as much where the surface is hollow, which no silhouette shows.
constexpr float kHollow = 2;
// The same of what lies inside of the hull where photographs do not say why,
// and how much more it is the deeper it lies.
constexpr float kInsideError = 3;
constexpr float kInsideGrowth = 0.25f;
constexpr float kMaxInside = 10;
// Times as much where fewer than two views see: nothing has shaped it.
constexpr float kUnseen = 3;
// What a point's error grows by for a neighbour, a pixel of distance: smooth
// surfaces bend away from where they are known.
constexpr float kGrowth = 0.15f;
constexpr int kSpreadSteps = 8;

using Values = std::vector<float>;

// Means over each point and its neighbours.
Values MeansOverNeighbors(const Values& values,
                          const VertexCorners& neighbors) {
  Values means(values.size());
  for (size_t i = 0; i < values.size(); ++i) {
    float sum = values[i];
    for (const uint32_t next : neighbors.Of(i)) {
      sum += values[next];
    }
    means[i] = sum / float(1 + neighbors.Of(i).size());
  }
  return means;
}

Values RegionSupport(const SurfaceEvidence& evidence) {
  Values support;
  for (const PointEvidence& point : evidence.values) {
    support.push_back(SupportOf(point) == Support::kPhotographs ? 1.0f : 0.0f);
  }
  for (int ring = 0; ring < kRegionRings; ++ring) {
    support = MeansOverNeighbors(support, evidence.points.neighbors);
  }
  return support;
}

// Where photographs tell nothing.
float ErrorOfShape(const PointEvidence& point) {
  if (!IsNearHull(point)) {
    return kInsideError +
           kInsideGrowth * std::min(point.hull_distance, kMaxInside);
  }
  const float error = kContourError +
                      kBetweenContours / float(1 + point.num_contours) +
                      std::max(0.0f, -point.hull_distance);
  return point.curvature < 0 ? kHollow * error : error;
}

float OwnError(const PointEvidence& point, float region) {
  float error = ErrorOfShape(point);
  if (point.num_views < 2) {
    error *= kUnseen;
  }
  if (point.precision > 0) {
    const float by_photographs = std::hypot(point.offset, 1 / point.precision) /
                                 std::max(region, kMinRegion);
    error = std::min(error, by_photographs);
  }
  return error;
}

}  // namespace

std::vector<float> ExpectedErrors(const SurfaceEvidence& evidence) {
  const Values region = RegionSupport(evidence);
  Values errors;
  for (size_t i = 0; i < evidence.values.size(); ++i) {
    errors.push_back(OwnError(evidence.values[i], region[i]));
  }
  const VertexCorners& neighbors = evidence.points.neighbors;
  for (int step = 0; step < kSpreadSteps; ++step) {
    Values spread = errors;
    for (size_t i = 0; i < errors.size(); ++i) {
      for (const uint32_t next : neighbors.Of(i)) {
        const float distance =
            (evidence.values[i].position - evidence.values[next].position)
                .norm() /
            float(evidence.pixel);
        spread[i] = std::min(spread[i], errors[next] + kGrowth * distance);
      }
    }
    errors.swap(spread);
  }
  return MeansOverNeighbors(errors, neighbors);
}

std::vector<float> VertexConfidence(const IndexedMesh& mesh,
                                    const SurfaceEvidence& evidence,
                                    const Context& context) {
  const Values errors = ExpectedErrors(evidence);
  const SurfacePoints& points = evidence.points;
  Values confidence(mesh.positions.size());
  const auto at = [&](size_t vertex) {
    const Eigen::Vector3f position = mesh.positions[vertex].cast<float>();
    float sum = 0;
    float weights = 0;
    const auto add = [&](uint32_t point) {
      const float distance =
          (evidence.values[point].position - position).norm() /
          float(evidence.pixel);
      const float weight = 1 / (1 + distance * distance);
      sum += weight * errors[point];
      weights += weight;
    };
    add(points.point_of[vertex]);
    for (const uint32_t next : points.neighbors.Of(points.point_of[vertex])) {
      add(next);
    }
    return 1 / (1 + sum / weights);
  };
  ParallelEach(context, confidence.size(), kConfidenceGrain, [&](size_t v) {
    confidence[v] = at(v);
  });
  return confidence;
}

}  // namespace octacut
