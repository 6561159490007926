// Options of a reconstruction on the command line and in project files.
#pragma once

#include "core/pipeline/options.h"
#include "plugin/option_manager.h"

namespace octacut {

void DeclareMeshingOptions(OptionManager& options,
                           ReconstructionOptions* meshing);

}  // namespace octacut
