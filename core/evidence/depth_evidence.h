// What depths say of voxels, of any level. For core/evidence alone.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/context.h"
#include "core/evidence/depth_confidence.h"
#include "core/evidence/inside_evidence.h"
#include "core/grid/voxel_grid.h"
#include "core/views/view_set.h"

namespace octacut {

size_t CountDepths(const std::vector<SweptDepthMap>& maps);

// Evidence of each voxel, in units of the graph's weights; > 0 for inside.
std::vector<float> EvidenceOf(const ViewSet& views,
                              const VoxelGrid& voxels,
                              const ReliableDepths& depths,
                              const InsideEvidenceOptions& options,
                              const Context& context);

// The same with the plausible ones of `paired`, the depths that at least one
// other view confirms, added to `depths` where those have none. They may be
// depths that were outvoted (docs/experiments/contradicting_depths.md).
std::vector<float> EvidenceWithPlausible(
    const ViewSet& views,
    const VoxelGrid& voxels,
    const std::vector<SweptDepthMap>& paired,
    const InsideEvidenceOptions& options,
    const Context& context,
    ReliableDepths* depths);

// Adds to `values`, the evidence of each voxel, that each view gives for matter
// before the surface where that lies in a pit.
void AddMatterInPits(const ViewSet& views,
                     const VoxelGrid& voxels,
                     const SurfaceVerdict& surface,
                     const InsideEvidenceOptions& options,
                     const Context& context,
                     std::vector<float>* values);

}  // namespace octacut
