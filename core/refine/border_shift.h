// How far the borders of the masks lie from where the photographs put the
// outlines: masks that were cut by hand, grown or shrunk err by the same pixels
// all around, and so does what follows them.
#pragma once

#include <optional>
#include <vector>

#include "core/refine/contour_targets.h"
#include "core/refine/local_surface.h"
#include "core/refine/offset_search.h"

namespace octacut {

// Pixels.
struct BorderExcess {
  double median = 0;
  double deviation = 0;  // the median distance from it
  // A hundredth of the borders lie at least so far inside of where the
  // photographs put the outlines: bites of the masks.
  double bites = 0;
};

// By how many pixels of their views `contours` lead farther outward than the
// offsets measured at their points, where `surfaces` are; weighted by the
// fourth power of the offsets' weights, since badly measured ones lie too far
// inside. Only points whose radius of curvature is at least `min_radius` pixels
// count. None where fewer than a hundred occluding contours, or than a tenth of
// them, could tell.
std::optional<BorderExcess> MeasureExcess(
    const std::vector<ContourTarget>& contours,
    const std::vector<LocalSurface>& surfaces,
    const std::vector<OffsetMeasurement>& measurements,
    double min_radius);

// What to make of a measured shift of the masks' borders that itself is only
// known to `noise`: nearly nothing of one below, nearly all of one far above.
// In any unit of length, the same for both.
double ShrinkShift(double measured, double noise);

}  // namespace octacut
