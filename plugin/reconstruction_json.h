// Levels, times and counts of a reconstruction, for the report.
#pragma once

#include "core/pipeline/summary.h"
#include "plugin/option_value.h"

namespace octacut {

Json ReconstructionToJson(const ReconstructionSummary& summary);

}  // namespace octacut
