// The end of a search: the least source side of all minimum cuts.
#pragma once

#include "core/base/context.h"
#include "core/cut/flow_state.h"

namespace octacut {

// Makes every free node that residual arcs lead to from a source node a
// reached one. Of a flow that is a maximum; which nodes these are depends
// neither on the number of threads nor on the order of work. Ranges of
// `range_bricks` bricks are flooded in parallel, then what is left.
template <typename Flow>
void FloodSourceSide(FlowState<Flow>& state,
                     uint32_t range_bricks,
                     const Context& context);

}  // namespace octacut
