// Options of photometric refinement on the command line, and its summary in
// the report.
#pragma once

#include "core/refine/refine_surface.h"
#include "plugin/option_manager.h"

namespace octacut {

void DeclareRefinementOptions(OptionManager& options,
                              RefineOptions* refinement);

// One weight for all comparisons of patches, in the cuts and in refinement.
void DeclareChromaWeight(OptionManager& options, double* chroma_weight);

Json RefinementToJson(const RefineSummary& summary);

}  // namespace octacut
