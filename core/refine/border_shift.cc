#include "core/refine/border_shift.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace octacut {
namespace {

constexpr size_t kMinRims = 100;

struct Excess {
  float length;
  double weight;
};

}  // namespace

std::optional<double> MedianExcess(
    const std::vector<EdgeTarget>& rims,
    const std::vector<OffsetMeasurement>& measurements) {
  std::vector<Excess> excesses;
  double sum = 0;
  for (const EdgeTarget& rim : rims) {
    const OffsetMeasurement& a = measurements[rim.places[0]];
    const OffsetMeasurement& b = measurements[rim.places[1]];
    if (a.weight > 0 && b.weight > 0) {
      const float measured = a.offset + rim.fraction * (b.offset - a.offset);
      excesses.push_back(
          {rim.target - measured, std::pow(std::min(a.weight, b.weight), 4)});
      sum += excesses.back().weight;
    }
  }
  if (excesses.size() < kMinRims) {
    return std::nullopt;
  }
  std::sort(excesses.begin(),
            excesses.end(),
            [](const Excess& one, const Excess& other) {
              return std::pair(one.length, one.weight) <
                     std::pair(other.length, other.weight);
            });
  double below = 0;
  const auto middle = std::find_if(
      excesses.begin(), excesses.end() - 1, [&](const Excess& excess) {
        below += excess.weight;
        return 2 * below >= sum;
      });
  return middle->length;
}

double ShrinkShift(double measured, double noise) {
  const double square = measured * measured;
  return square > 0 ? measured * square / (square + noise * noise) : 0;
}

}  // namespace octacut
