#include "core/refine/mattness.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/median.h"
#include "core/base/ramp.h"

namespace octacut {
namespace {

// Standard deviation of the brightness, grey levels: up to the first, the noise
// of photographs, and the surface looks the same to all views; from the second
// on, it does not.
constexpr float kEven = 1;
constexpr float kUneven = 2;
// The median distance from the median, as a standard deviation, over the
// standard deviation: 1 for a normal distribution, little where few views
// differ from the others.
constexpr float kFewViewsDiffer = 0.4f;
constexpr float kMostViewsDiffer = 0.6f;
// The standard deviation over the median brightness. Seen at up to 60 degrees
// from a light at the camera, a matt surface is between fully and half as
// bright: at most 0.25.
constexpr float kShading = 0.15f;
constexpr float kMoreThanShading = 0.3f;

float Deviation(const std::vector<float>& values) {
  const auto count = float(values.size());
  const float mean =
      std::accumulate(values.begin(), values.end(), 0.0f) / count;
  float squares = 0;
  for (const float value : values) {
    squares += (value - mean) * (value - mean);
  }
  return std::sqrt(squares / (count - 1));
}

}  // namespace

float Mattness(std::vector<float> brightness) {
  if (brightness.size() < 2) {
    return 1;
  }
  const float deviation = Deviation(brightness);
  if (deviation <= kEven) {
    return 1;
  }
  const MedianSpread most = SpreadAroundMedian(std::move(brightness));
  const float like_shading =
      Ramp(most.deviation / deviation, kFewViewsDiffer, kMostViewsDiffer) *
      Ramp(deviation / std::max(most.median, 1.0f), kMoreThanShading, kShading);
  return std::max(Ramp(deviation, kUneven, kEven), like_shading);
}

}  // namespace octacut
