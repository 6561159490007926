// Cuts of a level's crust, with their figures for the level's summary.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/crust/crust.h"
#include "core/cut/octahedral_cut.h"
#include "core/pipeline/cover_silhouettes.h"
#include "core/pipeline/options.h"
#include "core/pipeline/reconstruct.h"
#include "core/views/view_set.h"

namespace octacut {

// `state`, if any, as SolveOctahedralCut has it.
OctahedralCut CutCrust(const Crust& crust,
                       const std::vector<float>& weights,
                       const std::vector<float>& evidence,
                       const ReconstructionOptions& options,
                       const Context& context,
                       LevelSummary* summary,
                       OctahedralCutState* state = nullptr);

// Cuts again where `cut` leaves silhouettes uncovered that can be covered.
void CoverSilhouettes(const ViewSet& views,
                      const Crust& crust,
                      const std::vector<float>& weights,
                      const CoverPreference& preference,
                      const ReconstructionOptions& options,
                      const Context& context,
                      OctahedralCutState* state,
                      std::vector<float>* evidence,
                      OctahedralCut* cut,
                      LevelSummary* summary);

}  // namespace octacut
