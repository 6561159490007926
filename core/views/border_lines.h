// Edges of the photographs along lines across the borders of the masks.
#pragma once

#include <span>
#include <vector>

#include "core/views/outline_fit.h"
#include "core/views/view_set.h"

namespace octacut {

// Pixels from the border within which edges are looked for: masks that are
// farther off are wrong, not shifted.
inline constexpr float kEdgeRange = 6;

// Pixels by which borders lie outside edges, point by point: outside the
// strongest edge, and outside the nearest one that is comparable to it.
struct EdgeOffsets {
  std::vector<float> strongest;
  std::vector<float> nearest;
};

// At the points of the mask's border that are clear of the frame, as far as
// there are edges. `view` has an image. `fits`: of all blurs that it may have.
EdgeOffsets FindEdgeOffsets(const PreparedView& view,
                            std::span<const OutlineFit> fits);

}  // namespace octacut
