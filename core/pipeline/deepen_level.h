// A level's surface once more, where finer depths lead into it.
#pragma once

#include "core/base/context.h"
#include "core/crust/label_hierarchy.h"
#include "core/pipeline/options.h"
#include "core/pipeline/reconstruct.h"
#include "core/views/view_set.h"

namespace octacut {

// `solved` with the folds that FindFinerDepths finds; `hierarchy` holds the
// levels before it, `evidence` is that of l0. Adds its times to `summary`.
LabeledVoxels DeepenLevel(const ViewSet& views,
                          const InsideEvidence& evidence,
                          const LabelHierarchy& hierarchy,
                          LabeledVoxels solved,
                          const ReconstructionOptions& options,
                          const Context& context,
                          LevelSummary* summary);

}  // namespace octacut
