// What the borders of the masks contribute to a round of refinement: where the
// surface's contours should be, how far all borders are shifted, and how far
// vertices may leave the masks.
#pragma once

#include <vector>

#include "core/refine/contour_targets.h"
#include "core/refine/local_surface.h"
#include "core/refine/offset_search.h"
#include "core/refine/refine_round.h"
#include "core/refine/solve_offsets.h"

namespace octacut {

// Pixels by which vertices may leave a mask when nothing is known of its
// border.
inline constexpr double kLargestHullTolerance = 1.5;

// Sets num_contour_targets, border_shift and hull_tolerance of `summary`. The
// shift is judged only where `summary` knows the offsets of most points, of
// which `surfaces` and `measurements` have one each.
void JudgeBorders(const std::vector<ContourTarget>& contours,
                  const std::vector<LocalSurface>& surfaces,
                  const std::vector<OffsetMeasurement>& measurements,
                  const RoundPlan& plan,
                  RoundSummary* summary);

// Adds the edge targets to `problem`, whose lengths are in pixels.
void AddContourTargets(const std::vector<ContourTarget>& contours,
                       double pixel,
                       double weight,
                       OffsetProblem* problem);

}  // namespace octacut
