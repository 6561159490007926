#include "core/pipeline/options.h"

#include "core/base/check_option.h"

namespace octacut {

void EnergyOptions::Check() const {
  CheckOption(smoothness > 0 && smoothness <= 16,
              "smoothness",
              smoothness,
              "must be positive and at most 16");
  CheckOption(area_weight >= 1e-12 && area_weight <= 1,
              "area_weight",
              area_weight,
              "must be in 1e-12 .. 1");
  CheckEvidenceWeight("silhouette_weight", silhouette_weight);
  CheckEvidenceWeight("mask_border_weight", mask_border_weight);
}

void ReconstructionOptions::Check() const {
  masks.Check();
  hull.Check();
  evidence.Check();
  crust.Check();
  visibility.Check();
  consistency.Check();
  energy.Check();
  finish.Check();
  refinement.Check();
  CheckOption(target_level >= hull.hull_level && target_level <= 12,
              "target_level",
              target_level,
              "must be at least hull_level and at most 12");
  CheckOption(max_grow_rounds >= 0 && max_grow_rounds <= 16,
              "max_grow_rounds",
              max_grow_rounds,
              "must be in 0 .. 16");
}

}  // namespace octacut
