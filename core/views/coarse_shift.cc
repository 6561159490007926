#include "core/views/coarse_shift.h"

#include <cmath>
#include <optional>

#include "core/views/offset_peak.h"

namespace octacut {
namespace {

// A large shift is doubted if so many pixels from the borders as they are there
// is another peak, even of faint edges, that has more than this share of its
// height: the outline of an object with a painted rim is where the masks are.
constexpr float kAtBorder = 1.5f;
constexpr float kMaxBorderPeak = 0.5f;

}  // namespace

CoarseShift FindCoarseShift(const EdgePositions& edges) {
  const std::optional<float> shift =
      FindLonePeak(edges.comparable, kWideEdgeRange);
  if (!shift) {
    return {};
  }
  const auto height = [&](float center) {
    return PeakHeight(edges.all, kWideEdgeRange, center, kAtBorder);
  };
  if (std::abs(*shift) > kMinCoarseShift &&
      height(0) > kMaxBorderPeak * height(*shift)) {
    return {.is_doubted = true};
  }
  return {.shift = *shift, .is_known = true};
}

}  // namespace octacut
