// What the borders of the masks contribute to a round of refinement: where the
// surface's contours should be, how far all borders are shifted, and how far
// vertices may leave the masks.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/refine/offset_search.h"
#include "core/refine/refine_round.h"
#include "core/refine/seen_surface.h"
#include "core/refine/solve_offsets.h"

namespace octacut {

// Pixels by which vertices may leave a mask when nothing is known of its
// border.
inline constexpr double kLargestHullTolerance = 1.5;

// Adds the edge targets to `problem`, whose lengths are in pixels, and sets
// num_rim_targets, border_shift and hull_tolerance of `summary`. The shift is
// judged only where `summary` knows the offsets of most points.
void AddBorderTerms(const ViewSet& views,
                    const SeenSurface& seen,
                    const std::vector<OffsetMeasurement>& measurements,
                    double pixel,
                    const RoundPlan& plan,
                    const RefineOptions& options,
                    const Context& context,
                    OffsetProblem* problem,
                    RoundSummary* summary);

}  // namespace octacut
