// Which measured offsets others around them support.
//
// On plain and shiny surfaces the views agree by chance, at one offset here and
// at another one there. A surface is smooth at the scale of a few patches, so
// offsets that mean it are alike, also where their patches do not overlap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/vertex_corners.h"
#include "core/refine/offset_search.h"

namespace octacut {

// Measured offsets, one per point.
size_t NumMeasured(const std::vector<OffsetMeasurement>& measurements);

// Where at most half of the seen points have an offset that others support,
// lowers the weight of each of `measurements` by its support: the share of the
// seen points around it, just beyond its own patch, whose offsets differ from
// its own by no more than `tolerance` (unit coordinates). Offsets that few
// support get none. Elsewhere nothing changes: at creases and in hollows of a
// textured object, offsets without support are right. `neighbors` and
// `is_seen` are those of SeenSurface. The same for any number of threads.
void DropChanceOffsets(const VertexCorners& neighbors,
                       const std::vector<uint8_t>& is_seen,
                       double tolerance,
                       const Context& context,
                       std::vector<OffsetMeasurement>* measurements);

}  // namespace octacut
