// A body in draped cloth: folds of many widths all around it, all of the same
// depth in units of their width.
#pragma once

#include "core/benchmark/synthetic/implicit.h"

namespace octacut {

struct DraperyOptions {
  // A fold is a groove and the ridge beside it, both as wide as this half way
  // down, at the hem. The folds at +x are the widest; toward -x they get
  // narrower in equal ratios, on both sides alike.
  double max_width = 0.09;
  double min_width = 0.018;
  double depth = 2;  // of a groove below the ridges, in its own width
};

// Closed, of genus 0, 1.7 high, 0.8 in radius at the hem and less above it,
// where folds are narrower and shallower in the same ratio. The grooves run
// from the hem up to the shoulder, where they end, and sway aside. Their
// bottoms and the ridges are rounded. Throws OptionError where two folds do not
// fit on each side, or grooves would reach half way to the axis.
ImplicitShape MakeDrapery(const DraperyOptions& options);

}  // namespace octacut
