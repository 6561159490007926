// Takes back what the tolerance of masks has added to the hull in vain.
#pragma once

#include "core/base/context.h"
#include "core/evidence/inside_evidence.h"
#include "core/grid/voxel_grid.h"
#include "core/views/view_set.h"

namespace octacut {

// Takes off the hull's outermost voxels that are background in a view whose
// mask can be relied upon: the tolerance of masks was not needed there. Only
// the outermost, since what lies deeper is a hole in a mask and would become a
// tunnel. `evidence` is brought to the voxels that are left.
VoxelGrid TrimHull(const ViewSet& views,
                   const VoxelGrid& hull,
                   const Context& context,
                   InsideEvidence* evidence);

}  // namespace octacut
