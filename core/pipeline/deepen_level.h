// A level's surface once more, where finer depths lead into it.
#pragma once

#include "core/crust/label_hierarchy.h"
#include "core/pipeline/level_steps.h"
#include "core/pipeline/summary.h"

namespace octacut {

// `solved` with the folds that FindFinerDepths finds; `hierarchy` holds the
// levels before it. Adds its seconds and figures to `summary`.
SolvedLevel DeepenLevel(const LevelInputs& inputs,
                        const LabelHierarchy& hierarchy,
                        SolvedLevel solved,
                        LevelSummary* summary);

}  // namespace octacut
