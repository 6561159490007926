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

// Pixels of the views.
struct BorderVerdict {
  double shift = 0;  // by which the borders lie too far outside
  // By which vertices may leave a mask.
  double hull_tolerance = kLargestHullTolerance;
  // Of occluding contours, relative to RefineOptions::silhouette_weight.
  double contour_weight = 1;
};

// `surfaces` and `measurements` have an element for each point. Where most
// points that are seen have no offset (`knows_most` is false), the shift stays
// that of the plan, and contours weigh more, as far as they fit the masks.
BorderVerdict JudgeBorders(const std::vector<ContourTarget>& contours,
                           const std::vector<LocalSurface>& surfaces,
                           const std::vector<OffsetMeasurement>& measurements,
                           const RoundPlan& plan,
                           bool knows_most);

// Adds the edge targets to `problem`, whose lengths are in pixels.
void AddContourTargets(const std::vector<ContourTarget>& contours,
                       double pixel,
                       double weight,
                       OffsetProblem* problem);

}  // namespace octacut
