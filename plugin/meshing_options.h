// Options of a reconstruction on the command line, and its summary in the
// report.
#pragma once

#include "core/pipeline/options.h"
#include "core/pipeline/reconstruct.h"
#include "plugin/option_manager.h"

namespace octacut {

void DeclareMeshingOptions(OptionManager& options,
                           ReconstructionOptions* meshing);

Json ReconstructionToJson(const ReconstructionSummary& summary);

}  // namespace octacut
