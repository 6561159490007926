// What a labelling of a crust has inside, without what hangs in the air. For
// core/evidence alone.
#pragma once

#include <cstdint>
#include <vector>

#include "core/grid/face.h"
#include "core/grid/voxel_grid.h"

namespace octacut {

// One flag per voxel: it lies inside with all faces (`labels` has one element
// per voxel) and hangs together, through faces, with at least a tenth as many
// such voxels as the largest part has.
std::vector<uint8_t> FindMainMatter(const VoxelGrid& voxels,
                                    const std::vector<FaceLabels>& labels);

}  // namespace octacut
