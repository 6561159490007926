// How far the border of a mask lies from the edges of its photograph.
#pragma once

#include <span>
#include <vector>

#include "core/views/outline_fit.h"
#include "core/views/view_set.h"

namespace octacut {

// Pixels by which borders lie outside edges, line by line: outside the
// strongest edge, and outside the nearest one that is comparable to it.
struct EdgeOffsets {
  std::vector<float> strongest;
  std::vector<float> nearest;
  // Those of `nearest` with no comparable edge beside them.
  std::vector<float> alone;
};

// `view` has an image. `fits`: of all blurs that it may have.
EdgeOffsets FindEdgeOffsets(const PreparedView& view,
                            std::span<const OutlineFit> fits);

}  // namespace octacut
