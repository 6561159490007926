// One value for each voxel of a grid.
#pragma once

#include <vector>

#include "core/grid/voxel_grid.h"

namespace octacut {

struct VoxelValues {
  VoxelGrid voxels;
  std::vector<float> values;  // one per voxel

  // The value of the voxel that is, or holds, the one with `code` at `level`,
  // which is at least that of the grid; `otherwise` where there is none.
  float At(MortonCode code, int level, float otherwise) const {
    for (; level > voxels.Level(); --level) {
      code = ParentCode(code);
    }
    const VoxelGrid::Index index = voxels.Find(code);
    return index == VoxelGrid::kNone ? otherwise : values[index];
  }
  // That of the voxel that holds a point, unit coordinates.
  float AtPoint(const Eigen::Vector3f& point, float otherwise) const {
    const VoxelGrid::Index index = voxels.FindAt(point);
    return index == VoxelGrid::kNone ? otherwise : values[index];
  }
};

}  // namespace octacut
