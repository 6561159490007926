// By how many pixels masks are too large or too small, to a quarter of a pixel,
// however far that is.
#pragma once

#include "core/views/border_lines.h"

namespace octacut {

// Pixels by which borders lie outside the edges of the photographs.
struct CoarseShift {
  // 0 where edges agree on nothing, or are doubted.
  float shift = 0;
  // Most edges agree on a shift of more than kMinCoarseShift, but others are at
  // the borders as they are.
  bool is_doubted = false;
  bool is_known = false;  // edges agree, and are not doubted
};

// A shift that is less is found exactly around the borders as they are.
inline constexpr float kMinCoarseShift = 2;

// Where the edges agree that are comparable to the strongest one of their line,
// wherever that is: those at random are as frequent anywhere.
CoarseShift FindCoarseShift(const EdgePositions& edges);

}  // namespace octacut
