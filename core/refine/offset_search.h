// How far along its normal each piece of the surface has to move for the views
// to agree best.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/refine/local_surface.h"
#include "core/refine/refine_options.h"
#include "core/refine/surface_patch.h"
#include "core/refine/view_choice.h"
#include "core/views/view_set.h"

namespace octacut {

// What RefineOptions, which has the defaults and limits, comes to in one round.
// Lengths in pixels: the mean size at the point of those of its views.
struct OffsetSearch {
  double range;      // offsets in -range .. range
  double step;       // between tried offsets
  double spacing;    // between the samples of a patch
  double min_score;  // of an accepted peak
  PatchOptions patch;
};

// `range` and the step of RefineOptions in units of `scale` pixels.
OffsetSearch MakeOffsetSearch(const RefineOptions& options,
                              double range,
                              double scale);

struct OffsetMeasurement {
  bool is_measured = false;  // at least two views show the patch
  float offset = 0;          // from the local surface, unit coordinates
  float weight = 0;  // 1 / standard deviation, roughly, in pixels; 0: none
  float score_before = 0;  // at offset 0
  float mattness = 1;      // of Mattness, at offset 0
};

// One for each of `surfaces`, which are seen by `choices`. There is no offset
// where fewer than two views see, where the best score is too low or at the end
// of the range, or where a second peak is nearly as high.
std::vector<OffsetMeasurement> SearchOffsets(
    const ViewSet& views,
    const std::vector<LocalSurface>& surfaces,
    const std::vector<ChosenViews>& choices,
    const OffsetSearch& search,
    const Context& context,
    Phase* phase);

}  // namespace octacut
