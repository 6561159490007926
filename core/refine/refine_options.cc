#include "core/refine/refine_options.h"

#include "core/base/check_option.h"
#include "core/refine/surface_patch.h"

namespace octacut {

void RefineOptions::Check() const {
  views.Check();
  patch.Check();
  CheckOption(coarse_rounds >= 0 && coarse_rounds <= 4,
              "refinement.coarse_rounds",
              coarse_rounds,
              "must be in 0 .. 4");
  CheckOption(coarse_passes >= 1 && coarse_passes <= 4,
              "refinement.coarse_passes",
              coarse_passes,
              "must be in 1 .. 4");
  CheckOption(fit_radius > 0 && fit_radius <= 64,
              "refinement.fit_radius",
              fit_radius,
              "must be positive and at most 64");
  CheckOption(alignment_steps >= 0 && alignment_steps <= 16,
              "refinement.alignment_steps",
              alignment_steps,
              "must be in 0 .. 16");
  CheckOption(smoothness > 0 && smoothness <= 1e4,
              "refinement.smoothness",
              smoothness,
              "must be positive and at most 10000");
}

}  // namespace octacut
