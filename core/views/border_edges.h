// How far the borders of the masks lie from the edges that the photographs show
// along them. Masks that cover every pixel which the object touches, or that
// were grown or shrunk, are off by the same pixels all around, and so is the
// visual hull.
#pragma once

#include <optional>

#include "core/base/context.h"
#include "core/views/coarse_shift.h"
#include "core/views/view_set.h"

namespace octacut {

// Pixels of the views.
struct BorderEdges {
  double shift = 0;      // the borders lie that far outside the edges
  double deviation = 0;  // median distance of the edges from that
  // The share of points whose strongest edges agree to a pixel, and on what.
  double share = 0;
  double strongest_shift = 0;
};

// Along lines across the borders, edges are looked for within six pixels, in
// linear light, where a pixel's value is the mean of what it covers; edges
// beside clipped pixels do not count, since those look larger than they are.
// Most lines that hit texture or background have their strongest edge anywhere;
// those that agree form a peak. None where there is no such peak. The shift is
// that of the edges nearest to the border which have half the contrast of the
// strongest or more: where gloss mirrors the background at grazing angles, the
// outline of the object is fainter than the edges of reflections inside it. An
// edge lies where the change of the light begins (outline_fit.h), not where it
// is steepest.
std::optional<BorderEdges> MeasureBorderEdges(const ViewSet& views,
                                              const Context& context);

// Whether all masks are so far off that `edges`, which were measured within six
// pixels, miss the outline: the coarse shift of all views if that is more than
// two pixels and `edges` show no clear shift of less than five. A warning if
// the photographs have many edges, but show no outline.
CoarseShift FindLargeShift(const ViewSet& views,
                           const std::optional<BorderEdges>& edges,
                           const Context& context);

// Sets, in all views,
// - border_shift: 0 without edges; at most one pixel where it is doubted or
//   where strongest and nearest edges disagree; else at most five pixels;
// - border_shift_slack: a tenth of a pixel if at least half of the strongest
//   edges agree, the nearest ones agree with them to a pixel, and the shift is
//   within these limits; else infinite.
void ShiftBordersToEdges(const std::optional<BorderEdges>& edges,
                         bool is_doubted,
                         ViewSet* views);

// The borders of all masks are right: a shift of 0, known exactly.
void KeepBorders(ViewSet* views);

}  // namespace octacut
