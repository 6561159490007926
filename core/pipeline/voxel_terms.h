// What a crust's voxels contribute to the energy: photo-consistency and the
// silhouettes' evidence.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/crust/crust.h"
#include "core/pipeline/options.h"
#include "core/pipeline/reconstruct.h"
#include "core/views/view_set.h"
#include "core/visibility/visibility.h"

namespace octacut {

struct VoxelTerms {
  VoxelGrid voxels;
  std::vector<float> phi;  // photo-consistency, 0 .. 1
  // Evidence for inside (> 0: what fewer than two views see keeps the hull) or
  // outside (< 0: a view shows background), in units of the weights.
  std::vector<float> evidence;
};

// Brings `terms` up to `crust`, which is at least as large: voxels that have
// their terms keep them, so growing a crust costs what it adds. `mask_trust` is
// that of InsideEvidence.
void ExtendTerms(const ViewSet& views,
                 const std::vector<float>& mask_trust,
                 const Visibility& visibility,
                 const Crust& crust,
                 const ReconstructionOptions& options,
                 const Context& context,
                 VoxelTerms* terms,
                 LevelSummary* summary);

// psi(phi) + a of every voxel, HK06 eq. (3).
std::vector<float> EdgeWeights(const std::vector<float>& phi,
                               const EnergyOptions& options);

// Evidence for outside of the voxels whose footprint is background in some
// view: much where that is beyond doubt, less near the object, where the mask
// may be wrong. The others have none.
std::vector<float> SilhouetteEvidence(const ViewSet& views,
                                      const std::vector<float>& mask_trust,
                                      const VoxelGrid& voxels,
                                      const ReconstructionOptions& options,
                                      const Context& context);

}  // namespace octacut
