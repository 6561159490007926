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
  std::vector<float> hull_depth;  // as SilhouetteTerms has it
};

// Brings `terms` up to `crust`, which is at least as large: voxels that have
// their terms keep them, so growing a crust costs what it adds.
// `mask_confidence` is that of InsideEvidence.
void ExtendTerms(const ViewSet& views,
                 const std::vector<float>& mask_confidence,
                 const Visibility& visibility,
                 const Crust& crust,
                 const ReconstructionOptions& options,
                 const Context& context,
                 VoxelTerms* terms,
                 LevelSummary* summary);

// psi(phi) + a of every voxel, HK06 eq. (3).
std::vector<float> EdgeWeights(const std::vector<float>& phi,
                               const EnergyOptions& options);

struct SilhouetteTerms {
  // Evidence for outside (< 0) of voxels outside the border of some view's
  // object: all of the weight from half a voxel on. It is less where not all of
  // the voxel is farther than mask_tolerance from the border, since the mask
  // may be wrong there, and none on levels finer than l0. 0 for others.
  std::vector<float> evidence;
  // How deep each voxel's centre lies within the silhouettes, voxels: the least
  // distance to a border; negative outside. Borders of masks that may be too
  // small count where they leave out more than mask_tolerance.
  std::vector<float> hull_depth;
};

// One element a voxel each. `mask_confidence` is that of InsideEvidence.
SilhouetteTerms EstimateSilhouetteTerms(
    const ViewSet& views,
    const std::vector<float>& mask_confidence,
    const VoxelGrid& voxels,
    const ReconstructionOptions& options,
    const Context& context);

}  // namespace octacut
