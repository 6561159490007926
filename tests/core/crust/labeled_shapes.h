// Labellings of solids that are given by a function, for the tests of this
// folder.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "core/crust/label_hierarchy.h"
#include "core/grid/labeled_voxels.h"

namespace octacut::testing {

// Negative inside, positive outside; a distance in unit coordinates.
using Solid = std::function<double(const Eigen::Vector3d&)>;

inline Solid Ball(const Eigen::Vector3d& center, double radius) {
  return [=](const Eigen::Vector3d& x) { return (x - center).norm() - radius; };
}
// Round bar along z with flat ends.
inline Solid Rod(double radius, double low, double high) {
  return [=](const Eigen::Vector3d& x) {
    return std::max({(x - Eigen::Vector3d(0.5, 0.5, x.z())).norm() - radius,
                     low - x.z(),
                     x.z() - high});
  };
}
inline Solid Box(const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  return [=](const Eigen::Vector3d& x) {
    return std::max((min - x).maxCoeff(), (x - max).maxCoeff());
  };
}

inline Eigen::Vector3d FaceCenter(const Eigen::Vector3i& voxel,
                                  int face,
                                  int level) {
  Eigen::Vector3d center = voxel.cast<double>().array() + 0.5;
  center[face / 2] += (face & 1) ? 0.5 : -0.5;
  return center / (1 << level);
}

// Faces at the border of the cube are outside, as every cut has them.
inline FaceLabels LabelsOf(const Solid& solid,
                           const Eigen::Vector3i& voxel,
                           int level) {
  FaceLabels labels = 0;
  for (int face = 0; face < kNumFaces; ++face) {
    const Eigen::Vector3d center = FaceCenter(voxel, face, level);
    const bool at_border = center[face / 2] == 0 || center[face / 2] == 1;
    if (!at_border && solid(center) < 0) {
      labels |= FaceLabels(1 << face);
    }
  }
  return labels;
}

inline std::vector<FaceLabels> LabelsOf(const Solid& solid,
                                        const VoxelGrid& voxels) {
  std::vector<FaceLabels> labels;
  voxels.ForEach([&](VoxelGrid::Index, MortonCode code) {
    labels.push_back(LabelsOf(solid, DecodeMorton(code), voxels.Level()));
  });
  return labels;
}

// All voxels with their centre within `band` voxels of the solid's surface.
inline LabeledVoxels LabelSolid(const Solid& solid, int level, double band) {
  std::vector<MortonCode> codes;
  const int n = 1 << level;
  for (MortonCode code = 0; code < MortonCode(n) * n * n; ++code) {
    const Eigen::Vector3d center =
        (DecodeMorton(code).cast<double>().array() + 0.5) / n;
    if (std::abs(solid(center)) <= band / n) {
      codes.push_back(code);
    }
  }
  LabeledVoxels labeled;
  labeled.voxels = VoxelGrid::FromCodes(level, std::move(codes));
  labeled.labels = LabelsOf(solid, labeled.voxels);
  return labeled;
}

// One level with all voxels, as the one of l0 is.
inline LabelHierarchy OneLevel(const Solid& solid, int level) {
  LabelHierarchy hierarchy;
  hierarchy.Add(LabelSolid(solid, level, 1e9));
  return hierarchy;
}

}  // namespace octacut::testing
