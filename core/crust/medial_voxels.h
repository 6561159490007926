// Seeds for structures and gaps that are too thin to have an interior
// (exterior) outside the crust.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/context.h"
#include "core/grid/face.h"
#include "core/grid/voxel_grid.h"

namespace octacut {

// The least depth of medial voxels where parts as thin as a few voxels count.
inline constexpr int kMinMedialDepth = 2;

// Ties all faces of the medial voxels of a crust that are not too deep, inside
// ones (by `prior`, one per voxel) to the inside and outside ones to the
// outside. Depth is counted in 6-neighbour steps from the prior surface; a
// voxel is medial when it is `min_depth` to twelve deep, no neighbour is
// deeper, and no interface of its own kind is within reach. Faces with a tie
// keep theirs, and a voxel beside a tie of the other kind is left free. Returns
// the number of voxels tied.
size_t TieMedialVoxels(const VoxelGrid& voxels,
                       const std::vector<float>& prior,
                       int min_depth,
                       const Context& context,
                       std::vector<FaceTies>* ties);

}  // namespace octacut
