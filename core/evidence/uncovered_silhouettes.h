// What a labelling of the hull cuts off: a pixel that a mask shows as object
// has matter somewhere on its ray, so a labelling that leaves the ray empty
// has relied upon wrong depths (compare Sinha & Pollefeys, ICCV 2005).
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/base/context.h"
#include "core/grid/face.h"
#include "core/grid/voxel_grid.h"
#include "core/views/view_set.h"

namespace octacut {

struct UncoveredSilhouettes {
  size_t num_samples = 0;    // surely object, one hull voxel across each
  size_t num_uncovered = 0;  // of them, without matter on their ray
  // One per hull voxel: for each view that shows an uncovered sample at the
  // voxel one over the number of hull voxels on that ray. What is thin
  // collects much of it, what is thick little per voxel.
  std::vector<float> shares;

  // The share of the samples that is uncovered.
  double Share() const {
    return double(num_uncovered) / double(std::max<size_t>(num_samples, 1));
  }
};

// `labels` has one element per voxel of `hull`, as SolveOctahedralCut gives
// them. Samples near the silhouette's border do not count, as MapSamples says.
UncoveredSilhouettes FindUncoveredSilhouettes(
    const ViewSet& views,
    const VoxelGrid& hull,
    const std::vector<FaceLabels>& labels,
    const Context& context);

}  // namespace octacut
