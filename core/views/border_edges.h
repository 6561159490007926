// How far the borders of the masks lie from the edges that the photographs show
// along them. Masks that cover every pixel which the object touches, or that
// were grown or shrunk, are off by the same pixels all around, and so is the
// visual hull.
#pragma once

#include <optional>

#include "core/base/context.h"
#include "core/views/view_set.h"

namespace octacut {

// Pixels of the views.
struct BorderEdges {
  double shift = 0;      // the borders lie that far outside the edges
  double deviation = 0;  // median distance of the edges from that
  // The share of points whose strongest edges agree to a pixel, and on what.
  double share = 0;
  double strongest_shift = 0;
  // Around which edges were looked for, if not around the borders.
  double coarse_shift = 0;
  // Most edges are more than two pixels away, but others are at the borders.
  bool is_doubted = false;
};

// Along lines across the borders, edges are looked for within six pixels; and,
// where that finds no clear shift, around the shift on which most edges within
// sixteen pixels agree. They are looked for in linear light, where a pixel's
// value is the mean of what it covers; edges beside clipped pixels do not
// count, since those look larger than they are. Most lines that hit texture or
// background have their strongest edge anywhere; those that agree form a peak.
// None where there is no such peak, with a warning if there are many edges. The
// shift is that of the edges nearest to the border which have half the contrast
// of the strongest or more: where gloss mirrors the background at grazing
// angles, the outline of the object is fainter than the edges of reflections
// inside it. An edge lies where the change of the light begins (outline_fit.h),
// not where it is steepest.
std::optional<BorderEdges> MeasureBorderEdges(const ViewSet& views,
                                              const Context& context);

// Measures and sets PreparedView::border_shift of all views: 0 where there is
// nothing to measure, at most one pixel from the coarse shift where that is
// doubted or the strongest edges disagree with the nearest ones, and at most
// five from it in any case. border_shift_slack is a tenth of a pixel if at
// least half of the strongest edges agree, the nearest ones agree with them to
// a pixel, and the shift is within these limits; else it is infinite.
std::optional<BorderEdges> ShiftBordersToEdges(const Context& context,
                                               ViewSet* views);

// The borders of all masks are right: a shift of 0, known exactly.
void KeepBorders(ViewSet* views);

}  // namespace octacut
