// Voxels with a label for each of their faces: what a cut returns and what
// the manifold extraction takes.
#pragma once

#include <cstdint>
#include <vector>

#include "core/grid/face.h"
#include "core/grid/morphology.h"
#include "core/grid/voxel_grid.h"

namespace octacut {

struct LabeledVoxels {
  VoxelGrid voxels;
  std::vector<FaceLabels> labels;  // one per voxel; neighbours agree
};

// The voxels that the surface passes through.
inline VoxelGrid VoxelsOfCut(const LabeledVoxels& surface) {
  std::vector<uint8_t> cut(surface.labels.size());
  for (size_t i = 0; i < cut.size(); ++i) {
    cut[i] = IsCut(surface.labels[i]);
  }
  return Subset(surface.voxels, cut);
}

}  // namespace octacut
