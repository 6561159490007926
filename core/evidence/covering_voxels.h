// What has to be inside so that a labelling covers the silhouettes: each pixel
// that a mask surely shows as object has matter somewhere on its ray (the
// constraint of Cremers and Kolev, PAMI 2011).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/evidence/silhouette_samples.h"
#include "core/grid/face.h"
#include "core/grid/voxel_grid.h"
#include "core/views/view_set.h"

namespace octacut {

// How likely each voxel of a crust is to be matter, as far as a ray needs some.
struct CoverCandidates {
  // One per voxel, 0 .. 1; the highest of a ray is taken. Negative: not to be
  // taken, since it is tied to the outside or other masks deny it.
  std::vector<float> scores;
  // One per voxel: inside by a coarser labelling or an earlier cut; empty for
  // none.
  std::vector<uint8_t> is_likely;
};

struct CoveringVoxels {
  size_t num_voxels = 0;
  std::vector<uint8_t> is_covering;  // one per voxel
  // Samples that have no candidate on their rays.
  size_t num_impossible = 0;
};

// The voxels of `crust` that have to be inside besides those of `labels` (one a
// voxel) so that the samples of `maps`, which MapSamples has made of them, are
// covered, but for impossible ones. Rays go from what is covered outward.
//
// Where something is likely, voxels on uncovered rays of at least two views
// count: all likely ones, so that a lost part comes back as it was, and for
// each ray that meets none of them one beside matter, so that it grows back
// from there. What one view alone misses stays: masks that contradict each
// other would make fins and holes of it. Where nothing is likely, each ray gets
// its voxel of the highest score. Voxels that are taken are joined to the
// object where a short way leads to it.
CoveringVoxels FindCoveringVoxels(const ViewSet& views,
                                  const VoxelGrid& crust,
                                  const std::vector<FaceLabels>& labels,
                                  const std::vector<SampleMap>& maps,
                                  const CoverCandidates& candidates,
                                  const Context& context);

}  // namespace octacut
