#include "core/views/coarse_shift.h"

#include <cmath>
#include <cstddef>
#include <optional>

#include "core/base/parallel.h"
#include "core/views/offset_peak.h"

namespace octacut {
namespace {

// A large shift is doubted if so many pixels from the borders as they are there
// is another peak, even of faint edges, that has more than this share of its
// height: the outline of an object with a painted rim is where the masks are.
constexpr float kAtBorder = 1.5f;
constexpr float kMaxBorderPeak = 0.5f;

// The share of all lines that need an edge within a pixel of a shift: in
// photographs that are burnt out in part, few lines have any, and those agree
// by chance (docs/experiments/mask_borders.md).
constexpr double kMinLines = 0.2;

}  // namespace

std::vector<EdgePositions> FindEdgesOfViews(const ViewSet& views,
                                            const Context& context) {
  std::vector<EdgePositions> edges(views.size());
  ParallelEach(context, views.size(), 1, [&](size_t i) {
    if (views[i].pyramid.NumLevels() > 0) {
      edges[i] = FindAllEdges(views[i]);
    }
  });
  return edges;
}

CoarseShift FindCoarseShift(const EdgePositions& edges) {
  const std::optional<float> shift =
      FindLonePeak(edges.comparable, kWideEdgeRange);
  if (!shift) {
    return {};
  }
  if (double(WithinAPixel(edges.comparable, *shift).size()) <
      kMinLines * double(edges.num_lines)) {
    return {};
  }
  const auto height = [&](float center) {
    return PeakHeight(edges.all, kWideEdgeRange, center, kAtBorder);
  };
  if (std::abs(*shift) > kMinCoarseShift &&
      height(0) > kMaxBorderPeak * height(*shift)) {
    return {.shift = std::nullopt, .is_doubted = true};
  }
  return {.shift = shift};
}

}  // namespace octacut
