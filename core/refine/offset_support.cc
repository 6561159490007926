#include "core/refine/offset_support.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/ramp.h"
#include "core/refine/point_rings.h"

namespace octacut {
namespace {

constexpr size_t kSupportGrain = 8192;
// Steps between neighbouring points, two pixels each, to those that are asked:
// patches of seven pixels do not overlap there.
constexpr int kFirstRing = 4;
constexpr int kLastRing = 5;
// Shares of supporting points: up to the first, offsets are chance, from the
// second on they all count (docs/experiments/refinement_weights.md).
constexpr float kChance = 0.3f;
constexpr float kSupported = 0.6f;

// One per point; 1 for points without an offset or without neighbours that far.
std::vector<float> EstimateSupport(
    const VertexCorners& neighbors,
    const std::vector<uint8_t>& is_seen,
    double tolerance,
    const Context& context,
    const std::vector<OffsetMeasurement>& measurements) {
  std::vector<float> support(measurements.size(), 1);
  ParallelFor(
      context,
      measurements.size(),
      kSupportGrain,
      [&](size_t begin, size_t end) {
        PointRings rings(neighbors, measurements.size());
        for (size_t i = begin; i < end; ++i) {
          if (!(measurements[i].weight > 0)) {
            continue;
          }
          int num_seen = 0;
          int num_alike = 0;
          rings.ForEach(
              uint32_t(i), kFirstRing, kLastRing, [&](uint32_t other) {
                const OffsetMeasurement& theirs = measurements[other];
                num_seen += is_seen[other];
                num_alike += theirs.weight > 0 &&
                             std::abs(theirs.offset - measurements[i].offset) <=
                                 tolerance;
              });
          if (num_seen > 0) {
            support[i] =
                Ramp(float(num_alike) / float(num_seen), kChance, kSupported);
          }
        }
      });
  return support;
}

}  // namespace

size_t NumMeasured(const std::vector<OffsetMeasurement>& measurements) {
  return size_t(std::count_if(
      measurements.begin(), measurements.end(), [](const auto& measurement) {
        return measurement.weight > 0;
      }));
}

void DropChanceOffsets(const VertexCorners& neighbors,
                       const std::vector<uint8_t>& is_seen,
                       double tolerance,
                       const Context& context,
                       std::vector<OffsetMeasurement>* measurements) {
  const std::vector<float> support =
      EstimateSupport(neighbors, is_seen, tolerance, context, *measurements);
  std::vector<OffsetMeasurement> supported = *measurements;
  for (size_t i = 0; i < support.size(); ++i) {
    supported[i].weight *= support[i];
  }
  const size_t num_seen =
      size_t(std::count(is_seen.begin(), is_seen.end(), uint8_t{1}));
  if (2 * NumMeasured(supported) <= num_seen) {
    *measurements = std::move(supported);
  }
}

}  // namespace octacut
