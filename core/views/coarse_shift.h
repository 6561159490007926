// By how many pixels masks are too large or too small, to a quarter of a pixel,
// however far that is.
#pragma once

#include <optional>
#include <vector>

#include "core/base/context.h"
#include "core/views/border_lines.h"
#include "core/views/view_set.h"

namespace octacut {

struct CoarseShift {
  // Pixels by which borders lie outside the edges of the photographs. None
  // where edges agree on nothing, or are doubted.
  std::optional<float> shift;
  // Most edges agree on a shift of more than kMinCoarseShift, but others are at
  // the borders as they are.
  bool is_doubted = false;
};

// Smaller shifts are found more precisely around the borders as they are
// (MeasureBorderEdges).
inline constexpr float kMinCoarseShift = 2;

// One element per view (FindAllEdges); empty for views without an image.
std::vector<EdgePositions> FindEdgesOfViews(const ViewSet& views,
                                            const Context& context);

// Where the edges agree that are comparable to the strongest one of their line,
// wherever that is: those at random are as frequent anywhere. None where few of
// the lines have an edge there.
CoarseShift FindCoarseShift(const EdgePositions& edges);

}  // namespace octacut
