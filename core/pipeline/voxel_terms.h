// What a crust's voxels contribute to the energy: photo-consistency and the
// silhouettes' evidence.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/consistency/photo_consistency.h"
#include "core/crust/crust.h"
#include "core/pipeline/options.h"
#include "core/views/view_set.h"

namespace octacut {

struct VoxelTerms {
  VoxelGrid voxels;
  std::vector<float> phi;  // photo-consistency, 0 .. 1
  // Evidence for inside (> 0: what fewer than two views see keeps the hull) or
  // outside (< 0: a view shows background), in units of the weights.
  std::vector<float> evidence;
  std::vector<float> hull_depth;  // as SilhouetteTerms has it
};

// psi(phi) + a of every voxel, HK06 eq. (3).
std::vector<float> EdgeWeights(const std::vector<float>& phi,
                               const EnergyOptions& options);
// The same of a voxel that nobody sees.
float NeutralWeight(const ReconstructionOptions& options);

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

// One element of each per voxel. `mask_confidence` is that of InsideEvidence.
SilhouetteTerms EstimateSilhouetteTerms(
    const ViewSet& views,
    const std::vector<float>& mask_confidence,
    const VoxelGrid& voxels,
    const ReconstructionOptions& options,
    const Context& context);

// The voxels of a crust that have no terms yet.
struct AddedVoxels {
  std::vector<uint8_t> is_added;  // one per voxel of the crust
  VoxelGrid voxels;

  bool AreAll() const { return voxels.Size() == is_added.size(); }
};

AddedVoxels FindAddedVoxels(const Crust& crust, const VoxelTerms& terms);

// Evidence for inside of a voxel of `level` that fewer than two views see.
float UnseenEvidence(int level, const ReconstructionOptions& options);

// The terms of `crust`: those of `terms` and, of the voxels that were added,
// what `consistency` and `silhouettes` have for them.
VoxelTerms MergeTerms(const VoxelGrid& crust,
                      const VoxelTerms& terms,
                      const AddedVoxels& added,
                      const PhotoConsistency& consistency,
                      const SilhouetteTerms& silhouettes,
                      float unseen_evidence);

}  // namespace octacut
