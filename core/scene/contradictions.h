// Views whose mask or pose contradicts the others'.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/context.h"
#include "core/scene/scene.h"
#include "core/scene/sight_lines.h"

namespace octacut {

// How one view fits the others. A mask that is shifted, mirrored, another
// view's or another object's shows object where none can be, and denies it
// where the others show it.
struct ViewFit {
  // The share of the object's pixels in this view that no point explains:
  // everywhere on the line of sight, more of the other views than may be wrong
  // deny the object.
  double unexplained = 0;
  // The share of the object's pixels in the other views that nothing explains
  // because of this view. It is a mean over the other views without those that
  // lose most, since one view alone is not enough evidence.
  double taken = 0;
};

// The fit of each view to those of the others that are `active`, of which at
// most `max_wrong` are wrong where they deny a point.
std::vector<ViewFit> FitOfViews(const SightLines& lines,
                                const std::vector<bool>& active,
                                size_t max_wrong);

struct ContradictingView {
  size_t view = 0;
  ViewFit fit;  // to the views that do not contradict each other
  // Whether it takes from the others, or shows something else altogether.
  bool is_grave = false;
};

struct Contradictions {
  // False: the views do not bound the object, and nothing can be said.
  bool is_judged = false;
  std::vector<ContradictingView> views;  // by number
  // The largest figures of those that are left, not of one view in general.
  ViewFit largest_left;
};

// Finds the views that contradict the others, up to a third of all. Needs only
// their masks, of low resolution will do, and cameras. The same for any number
// of threads.
Contradictions FindContradictions(const std::vector<View>& views,
                                  const Context& context);

}  // namespace octacut
