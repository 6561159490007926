#include "core/refine/border_shift.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace octacut {
namespace {

constexpr size_t kMinRims = 100;
constexpr size_t kMinShare = 10;  // one in so many of all rims

struct Excess {
  float pixels;
  double weight;
};

}  // namespace

std::optional<double> MedianExcess(
    const std::vector<RimTarget>& rims,
    const std::vector<LocalSurface>& surfaces,
    const std::vector<OffsetMeasurement>& measurements,
    double min_radius,
    double curvature_bias) {
  std::vector<Excess> excesses;
  double sum = 0;
  for (const auto& [edge, pixels_per_unit] : rims) {
    const OffsetMeasurement& a = measurements[edge.places[0]];
    const OffsetMeasurement& b = measurements[edge.places[1]];
    // In 1 / pixels.
    const double curvature = std::max(surfaces[edge.places[0]].Curvature(),
                                      surfaces[edge.places[1]].Curvature()) /
                             pixels_per_unit;
    if (a.weight > 0 && b.weight > 0 && min_radius * curvature <= 1) {
      const float measured = a.offset + edge.fraction * (b.offset - a.offset);
      excesses.push_back({(edge.target - measured) * pixels_per_unit -
                              float(curvature_bias * curvature),
                          std::pow(std::min(a.weight, b.weight), 4)});
      sum += excesses.back().weight;
    }
  }
  if (excesses.size() < std::max(kMinRims, rims.size() / kMinShare)) {
    return std::nullopt;
  }
  std::sort(excesses.begin(),
            excesses.end(),
            [](const Excess& one, const Excess& other) {
              return std::pair(one.pixels, one.weight) <
                     std::pair(other.pixels, other.weight);
            });
  double below = 0;
  const auto middle = std::find_if(
      excesses.begin(), excesses.end() - 1, [&](const Excess& excess) {
        below += excess.weight;
        return 2 * below >= sum;
      });
  return middle->pixels;
}

double ShrinkShift(double measured, double noise) {
  const double square = measured * measured;
  return square > 0 ? measured * square / (square + noise * noise) : 0;
}

}  // namespace octacut
