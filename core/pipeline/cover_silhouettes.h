// Cuts that cover the silhouettes: what the masks surely show stays matter,
// whatever depths and photo-consistency say.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/crust/crust.h"
#include "core/grid/face.h"
#include "core/views/view_set.h"

namespace octacut {

// What speaks for matter where rays are uncovered, one per voxel of a crust.
struct CoverPreference {
  // For the first cut: its evidence, in units of the weights. Empty:
  // crust.prior says what an earlier cut or a coarser level has found.
  std::span<const float> evidence;
  // As SilhouetteTerms has it: no voxel outside of the hull covers anything.
  const std::vector<float>& hull_depth;
};

struct CoverDemand {
  double uncovered = 0;   // share of the samples that are surely object
  double impossible = 0;  // of those, without a voxel that could cover them
  size_t num_voxels = 0;  // that have to be inside
};

// Makes `evidence` so strong for the voxels that FindCoveringVoxels finds that
// a cut of `crust` must have them inside. What `labels` has inside stays so,
// since evidence for inside only takes from the outside: one more cut covers
// all that FindCoveringVoxels asks for.
CoverDemand DemandCover(const ViewSet& views,
                        const Crust& crust,
                        const std::vector<FaceLabels>& labels,
                        const CoverPreference& preference,
                        const Context& context,
                        std::vector<float>* evidence);

}  // namespace octacut
