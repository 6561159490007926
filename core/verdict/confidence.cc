#include "core/verdict/confidence.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/verdict/surface_support.h"

namespace octacut {
namespace {

constexpr size_t kGrain = 4096;
// Rings of places over which it is asked whether photographs decide: where they
// seldom do, agreement is chance.
constexpr int kRegionRings = 3;
// What the views' agreement leaves open even where it is rarest, in the errors
// of places where it is the rule.
constexpr float kMinRegion = 0.05f;
// Pixels. A visual hull touches the object along the rims of the views alone
// and lies outside of it between them: it is the closer the more rims are near.
// As measured on a polished bronze, a glazed porcelain and a painted figure
// with a truth (docs/design.md).
constexpr float kRimError = 0.4f;
constexpr float kBetweenRims = 3;
// Times as much where the surface is hollow, which no silhouette shows.
constexpr float kHollow = 2;
// The same of what lies inside of the hull where photographs do not say why,
// and how much more it is the deeper it lies.
constexpr float kInsideError = 3;
constexpr float kInsideGrowth = 0.25f;
constexpr float kMaxInside = 10;
// Times as much where fewer than two views see: nothing has shaped it.
constexpr float kUnseen = 3;
// What a place's error grows by for a neighbour, a pixel of distance: smooth
// surfaces bend away from where they are known.
constexpr float kGrowth = 0.15f;
constexpr int kSpreadSteps = 8;

using Values = std::vector<float>;

// Means over each place and its neighbours.
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
  for (const PlaceEvidence& place : evidence.values) {
    support.push_back(SupportOf(place) == Support::kPhotographs ? 1.0f : 0.0f);
  }
  for (int ring = 0; ring < kRegionRings; ++ring) {
    support = MeansOverNeighbors(support, evidence.places.neighbors);
  }
  return support;
}

// Where photographs tell nothing.
float ErrorOfShape(const PlaceEvidence& place) {
  if (!IsNearHull(place)) {
    return kInsideError +
           kInsideGrowth * std::min(place.hull_distance, kMaxInside);
  }
  const float error = kRimError + kBetweenRims / float(1 + place.num_rims) +
                      std::max(0.0f, -place.hull_distance);
  return place.bend < 0 ? kHollow * error : error;
}

float OwnError(const PlaceEvidence& place, float region) {
  float error = ErrorOfShape(place);
  if (place.num_views < 2) {
    error *= kUnseen;
  }
  if (place.precision > 0) {
    const float by_photographs = std::hypot(place.offset, 1 / place.precision) /
                                 std::max(region, kMinRegion);
    error = std::min(error, by_photographs);
  }
  return error;
}

}  // namespace

std::vector<float> ExpectedErrors(const SurfaceEvidence& evidence,
                                  double pixel) {
  const Values region = RegionSupport(evidence);
  Values errors;
  for (size_t i = 0; i < evidence.values.size(); ++i) {
    errors.push_back(OwnError(evidence.values[i], region[i]));
  }
  const VertexCorners& neighbors = evidence.places.neighbors;
  for (int step = 0; step < kSpreadSteps; ++step) {
    Values spread = errors;
    for (size_t i = 0; i < errors.size(); ++i) {
      for (const uint32_t next : neighbors.Of(i)) {
        const float distance =
            (evidence.values[i].position - evidence.values[next].position)
                .norm() /
            float(pixel);
        spread[i] = std::min(spread[i], errors[next] + kGrowth * distance);
      }
    }
    errors.swap(spread);
  }
  return MeansOverNeighbors(errors, neighbors);
}

std::vector<float> VertexConfidence(const IndexedMesh& mesh,
                                    const SurfaceEvidence& evidence,
                                    double pixel,
                                    const Context& context) {
  const Values errors = ExpectedErrors(evidence, pixel);
  const SurfacePlaces& places = evidence.places;
  Values confidence(mesh.positions.size());
  const auto at = [&](size_t vertex) {
    const Eigen::Vector3f position = mesh.positions[vertex].cast<float>();
    float sum = 0;
    float weights = 0;
    const auto add = [&](uint32_t place) {
      const float distance =
          (evidence.values[place].position - position).norm() / float(pixel);
      const float weight = 1 / (1 + distance * distance);
      sum += weight * errors[place];
      weights += weight;
    };
    add(places.place_of[vertex]);
    for (const uint32_t next : places.neighbors.Of(places.place_of[vertex])) {
      add(next);
    }
    return 1 / (1 + sum / weights);
  };
  ParallelFor(
      context, confidence.size(), kGrain, [&](size_t begin, size_t end) {
        for (size_t v = begin; v < end; ++v) {
          confidence[v] = at(v);
        }
      });
  return confidence;
}

}  // namespace octacut
