// The voxels of a grid, for comparisons.
#pragma once

#include <vector>

#include "core/grid/voxel_grid.h"

namespace octacut {

// In order.
inline std::vector<MortonCode> CodesOf(const VoxelGrid& grid) {
  std::vector<MortonCode> codes;
  codes.reserve(grid.Size());
  grid.ForEach(
      [&](VoxelGrid::Index, MortonCode code) { codes.push_back(code); });
  return codes;
}

}  // namespace octacut
