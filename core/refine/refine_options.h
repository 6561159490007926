// Options of photometric refinement. Lengths are in pixels of the views at the
// surface: of the photographs as they are held, reduced to what the target
// level needs (View::scale), not as they were taken.
#pragma once

#include "core/refine/surface_patch.h"
#include "core/refine/view_choice.h"

namespace octacut {

struct RefineOptions {
  ViewChoiceOptions views;
  PatchOptions patch;  // samples are a pixel of the round apart
  // Rounds at the scale of the views, the first within `range`, each later one
  // within half of the one before, but at least two steps; 1 .. 8.
  int fine_rounds = 2;
  // Rounds before, each at half the resolution of the next; 0 .. 4.
  int coarse_rounds = 2;
  // How often these are run: what is off by much is carried farther each time;
  // 1 .. 4.
  int coarse_passes = 2;
  double range = 3;
  double step = 0.5;  // between tried offsets
  // Between the places where offsets are measured.
  double measure_spacing = 2;
  // Of the pieces of the surface that are taken for smooth.
  double fit_radius = 9;
  double min_score = 0.2;  // of an accepted offset
  // Steps of photometric alignment of the views in the last round of each
  // coarse pass but the first, and each one at their scale; 0: their poses are
  // exact.
  int alignment_steps = 4;
  // Weight of the surface's bend, against an offset that is known to a pixel.
  double smoothness = 30;
  // Offsets that are wrong by more than this many standard deviations weigh
  // like outliers.
  double outlier_scale = 2;
  // Weight of the masks' borders, like that of an offset; 0: none.
  double silhouette_weight = 1;
  // Pixels to which the photographs tell how far the masks' borders are shifted
  // as a whole, less where all rims say the same: much smaller shifts are taken
  // for noise. Large: masks are right.
  double border_noise = 0.3;
  void Check() const;
};

}  // namespace octacut
