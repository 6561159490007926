// Options of photometric refinement. Lengths are in pixels of the views at the
// surface: of the photographs as they are held, reduced to what the target
// level needs (View::scale), not as they were taken.
#pragma once

#include "core/refine/surface_patch.h"
#include "core/refine/view_choice.h"

namespace octacut {

// What other values gave is in the tables of docs/experiments, in the pages
// that begin with refinement_; the sections are named below.
struct RefineOptions {
  ViewChoiceOptions views;
  PatchOptions patch;  // samples are a pixel of the round apart
  // Rounds at the scale of the views, the first within kRange, each later one
  // within half of the one before, but at least two steps. A third
  // one makes no difference ("What made refinement good").
  static constexpr int kFineRounds = 2;
  // Rounds before, each at half the resolution of the next; 0 .. 4. A third
  // one gains on rocker and loses on the example ("What made refinement good").
  int coarse_rounds = 2;
  // How often these are run: what is off by much is carried farther each time;
  // 1 .. 4.
  int coarse_passes = 2;
  // 2 and 1.5 are worse ("What made refinement good").
  static constexpr double kRange = 3;
  // Between tried offsets; not varied alone.
  static constexpr double kStep = 0.5;
  // Between the points where offsets are measured. 1.5 costs a third more time
  // for F 0.949 instead of 0.948 ("Patches of 7 x 7").
  static constexpr double kMeasureSpacing = 2;
  // The radius of the pieces of the surface that are assumed smooth; 5 and 6
  // are worse ("Patches lie on fitted quadrics", "Patches of 7 x 7"). The last
  // rounds (narrow_rounds.h) have smaller ones.
  double fit_radius = 9;
  // The least score of an accepted offset; 0.3 is worse ("What made refinement
  // good").
  static constexpr double kMinScore = 0.2;
  // Steps of photometric alignment in each round that aligns: the last one of
  // every coarse pass but the first, and the fine rounds. 0: the poses are
  // exact.
  int alignment_steps = 4;
  // Weight of the bending energy relative to an offset that is known to a
  // pixel. 20 and 45 are worse ("Patches of 7 x 7"). The last rounds have less.
  double smoothness = 30;
  // Offsets that are wrong by more than this many standard deviations weigh
  // like outliers.
  static constexpr double kOutlierScale = 2;
  // Weight of the masks' borders, like that of an offset. Twice as much makes
  // no difference where most points have an offset ("What made refinement
  // good"); in rounds in which they have none, BorderVerdict raises it.
  static constexpr double kSilhouetteWeight = 1;
  void Check() const;
};

}  // namespace octacut
