#include "core/refine/border_shift.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace octacut {
namespace {

constexpr size_t kMinContourTargets = 100;
constexpr size_t kContourDivisor = 10;  // one in so many occluding contours
constexpr double kShareOfBites = 0.01;

struct ContourExcess {
  float pixels;
  double weight;
};

// The value that `share` of the weight does not exceed; in any order of
// `values`.
float WeightedQuantile(std::vector<ContourExcess> values, double share) {
  std::sort(values.begin(),
            values.end(),
            [](const ContourExcess& one, const ContourExcess& other) {
              return std::pair(one.pixels, one.weight) <
                     std::pair(other.pixels, other.weight);
            });
  double sum = 0;
  for (const ContourExcess& value : values) {
    sum += value.weight;
  }
  double below = 0;
  return std::find_if(values.begin(),
                      values.end() - 1,
                      [&](const ContourExcess& value) {
                        below += value.weight;
                        return below >= share * sum;
                      })
      ->pixels;
}

}  // namespace

std::optional<BorderExcess> MeasureExcess(
    const std::vector<ContourTarget>& contours,
    const std::vector<LocalSurface>& surfaces,
    const std::vector<OffsetMeasurement>& measurements,
    double min_radius) {
  std::vector<ContourExcess> excesses;
  for (const auto& [edge, pixels_per_unit] : contours) {
    const OffsetMeasurement& a = measurements[edge.points[0]];
    const OffsetMeasurement& b = measurements[edge.points[1]];
    // In 1 / pixels.
    const double curvature = std::max(surfaces[edge.points[0]].Curvature(),
                                      surfaces[edge.points[1]].Curvature()) /
                             pixels_per_unit;
    if (a.weight > 0 && b.weight > 0 && min_radius * curvature <= 1) {
      const float measured = a.offset + edge.fraction * (b.offset - a.offset);
      excesses.push_back({(edge.target - measured) * pixels_per_unit,
                          std::pow(std::min(a.weight, b.weight), 4)});
    }
  }
  if (excesses.size() <
      std::max(kMinContourTargets, contours.size() / kContourDivisor)) {
    return std::nullopt;
  }
  const float median = WeightedQuantile(excesses, 0.5);
  const float bites = -WeightedQuantile(excesses, kShareOfBites);
  for (ContourExcess& excess : excesses) {
    excess.pixels = std::abs(excess.pixels - median);
  }
  return BorderExcess{
      median, WeightedQuantile(std::move(excesses), 0.5), bites};
}

double ShrinkShift(double measured, double noise) {
  const double square = measured * measured;
  return square > 0 ? measured * square / (square + noise * noise) : 0;
}

}  // namespace octacut
