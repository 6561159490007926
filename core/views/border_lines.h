// Edges of the photographs along lines across the borders of the masks.
#pragma once

#include <vector>

#include "core/views/view_set.h"

namespace octacut {

// Pixels from the border within which edges are looked for: masks that are
// farther off are wrong, not shifted.
inline constexpr float kEdgeRange = 6;
// Pixels between the samples of a line.
inline constexpr float kEdgeStep = 0.25f;

// Pixels by which borders lie outside edges, point by point: outside the
// strongest edge, and outside the nearest one that is comparable to it.
struct EdgeOffsets {
  std::vector<float> strongest;
  std::vector<float> nearest;
};

// At the points of the mask's border that are clear of the frame, as far as
// there are edges. `view` has an image.
EdgeOffsets FindEdgeOffsets(const PreparedView& view);

}  // namespace octacut
