// Labellings of the faces of dense blocks of voxels for tests.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "core/grid/voxel_grid.h"

namespace octacut {

struct LabelledCrust {
  VoxelGrid crust;
  std::vector<FaceLabels> labels;
};

// Labels all faces of the voxels [low, low + size) of a grid of `level`.
// `inside(axis, x, y, z)` tells of the face on the lower side of voxel (x, y,
// z) along `axis`; it is asked for coordinates 0 .. size, relative to `low`,
// and `border` overrules it on the border of the block.
inline LabelledCrust LabelBlock(
    int level,
    const Eigen::Vector3i& low,
    const Eigen::Vector3i& size,
    bool border,
    const std::function<bool(int axis, int x, int y, int z)>& inside) {
  std::vector<MortonCode> codes;
  for (int z = 0; z < size.z(); ++z) {
    for (int y = 0; y < size.y(); ++y) {
      for (int x = 0; x < size.x(); ++x) {
        codes.push_back(EncodeMorton(low + Eigen::Vector3i(x, y, z)));
      }
    }
  }
  LabelledCrust result;
  result.crust = VoxelGrid::FromCodes(level, codes);
  result.labels.resize(result.crust.Size());
  result.crust.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const Eigen::Vector3i voxel = DecodeMorton(code) - low;
    for (int face = 0; face < kNumFaces; ++face) {
      Eigen::Vector3i at = voxel;
      at[face / 2] += face & 1;
      const bool on_border =
          at[face / 2] == 0 || at[face / 2] == size[face / 2];
      const bool label =
          on_border ? border : inside(face / 2, at.x(), at.y(), at.z());
      result.labels[index] |= FaceLabels(unsigned(label) << face);
    }
  });
  return result;
}

}  // namespace octacut
