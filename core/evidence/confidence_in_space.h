// The confidence in depths as a function of space.
#pragma once

#include "core/base/context.h"
#include "core/evidence/depth_confidence.h"
#include "core/grid/voxel_grid.h"
#include "core/grid/voxel_values.h"
#include "core/views/view_set.h"

namespace octacut {

// For each voxel of the hull the mean confidence in the depths that views have
// found near it, over its brick and the bricks within two steps, of which the
// nearer ones weigh more; that of the scene where there are none.
VoxelValues ConfidenceInSpace(const ViewSet& views,
                              const VoxelGrid& hull,
                              const ReliableDepths& depths,
                              const Context& context);

}  // namespace octacut
