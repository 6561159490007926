// Which measured offsets others around them support.
//
// On plain and shiny surfaces the views agree by chance, at one offset here and
// at another one there. A surface is smooth at the scale of a few patches, so
// offsets that mean it are alike, also where their patches do not overlap.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/vertex_corners.h"
#include "core/refine/offset_search.h"

namespace octacut {

// Lowers the weight of each of `measurements`, one a place, by the share of the
// seen places around it, just beyond its own patch, whose offsets differ from
// its own by no more than `tolerance` (unit coordinates): to nothing where few
// do. Places without an offset support none. `neighbors` and `is_seen` are
// those of SeenSurface. The same bytes for any number of threads.
void WeighBySupport(const VertexCorners& neighbors,
                    const std::vector<uint8_t>& is_seen,
                    double tolerance,
                    const Context& context,
                    std::vector<OffsetMeasurement>* measurements);

}  // namespace octacut
