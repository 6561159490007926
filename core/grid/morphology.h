// Set operations on voxel grids, 64 voxels at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/grid/voxel_grid.h"

namespace octacut {

// The grid dilated `steps` times, clipped to the root cube. Steps alternate
// between 26 and 6 neighbours, which comes closer to a ball than either does
// alone: a slanted crust gets about as thick as an upright one.
VoxelGrid Dilate(const VoxelGrid& grid, int steps, const Context& context);

// The eight children of every voxel, one level finer.
VoxelGrid Children(const VoxelGrid& grid);

// The voxels whose element of `keep` (one per voxel) is not 0.
VoxelGrid Subset(const VoxelGrid& grid, std::span<const uint8_t> keep);

// All voxels of either grid; both of one level.
VoxelGrid Union(const VoxelGrid& a, const VoxelGrid& b);

}  // namespace octacut
