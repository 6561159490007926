// One level of the hierarchy: from a crust to its labelling.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/crust/crust.h"
#include "core/crust/label_hierarchy.h"
#include "core/pipeline/options.h"
#include "core/pipeline/reconstruct.h"
#include "core/views/view_set.h"

namespace octacut {

// The labelling of l0: a first cut by the evidence alone gives a surface that
// visibility can be estimated from, the second one the labelling.
LabeledVoxels SolveInitialLevel(const ViewSet& views,
                                const VoxelGrid& hull,
                                const InsideEvidence& evidence,
                                const ReconstructionOptions& options,
                                const Context& context,
                                LevelSummary* summary);

// The labelling of the level after hierarchy.Finest(); its crust is grown
// where the cut touches its border. `evidence` is that of l0.
LabeledVoxels SolveFinerLevel(const ViewSet& views,
                              const InsideEvidence& evidence,
                              const LabelHierarchy& hierarchy,
                              const ReconstructionOptions& options,
                              const Context& context,
                              LevelSummary* summary);

}  // namespace octacut
