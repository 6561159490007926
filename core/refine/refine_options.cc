#include "core/refine/refine_options.h"

#include "core/base/check_option.h"
#include "core/refine/surface_patch.h"

namespace octacut {

void RefineOptions::Check() const {
  views.Check();
  patch.Check();
  CheckOption(fine_rounds >= 1 && fine_rounds <= 8,
              "refinement.fine_rounds",
              fine_rounds,
              "must be in 1 .. 8");
  CheckOption(coarse_rounds >= 0 && coarse_rounds <= 4,
              "refinement.coarse_rounds",
              coarse_rounds,
              "must be in 0 .. 4");
  CheckOption(coarse_passes >= 1 && coarse_passes <= 4,
              "refinement.coarse_passes",
              coarse_passes,
              "must be in 1 .. 4");
  CheckOption(step > 0 && step <= 4,
              "refinement.step",
              step,
              "must be positive and at most 4");
  CheckOption(range >= 2 * step && range <= 64,
              "refinement.range",
              range,
              "must be at least two steps and at most 64");
  CheckOption(measure_spacing >= 0 && measure_spacing <= 16,
              "refinement.measure_spacing",
              measure_spacing,
              "must be in 0 .. 16");
  CheckOption(fit_radius > 0 && fit_radius <= 64,
              "refinement.fit_radius",
              fit_radius,
              "must be positive and at most 64");
  CheckOption(min_score >= 0 && min_score < 1,
              "refinement.min_score",
              min_score,
              "must be at least 0 and below 1");
  CheckOption(alignment_steps >= 0 && alignment_steps <= 16,
              "refinement.alignment_steps",
              alignment_steps,
              "must be in 0 .. 16");
  CheckOption(smoothness > 0 && smoothness <= 1e4,
              "refinement.smoothness",
              smoothness,
              "must be positive and at most 10000");
  CheckOption(outlier_scale > 0,
              "refinement.outlier_scale",
              outlier_scale,
              "must be positive");
  CheckOption(silhouette_weight > 0,
              "refinement.silhouette_weight",
              silhouette_weight,
              "must be positive");
}

}  // namespace octacut
