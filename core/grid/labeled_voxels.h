// Voxels with a label for each of their faces: what a cut returns and what
// the manifold extraction takes.
#pragma once

#include <vector>

#include "core/grid/face.h"
#include "core/grid/voxel_grid.h"

namespace octacut {

struct LabeledVoxels {
  VoxelGrid voxels;
  std::vector<FaceLabels> labels;  // one per voxel; neighbours agree
};

}  // namespace octacut
