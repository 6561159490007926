// The labellings of all levels so far. A level's cut decides only within its
// crust; whether a voxel outside of the crust is inside or outside the object
// is known from the first coarser level whose crust holds its ancestor.
#pragma once

#include <vector>

#include "core/grid/face.h"
#include "core/grid/voxel_grid.h"

namespace octacut {

// A crust with the labels that its cut found, one a voxel.
struct LabeledCrust {
  VoxelGrid voxels;
  std::vector<FaceLabels> labels;
};

class LabelHierarchy {
 public:
  // Levels are added from coarse to fine, each one level finer.
  void Add(LabeledCrust level);
  bool Empty() const { return levels_.empty(); }
  const LabeledCrust& Finest() const { return levels_.back(); }

  // Share of the voxel (one level finer than Finest() or coarser) that is
  // inside, as far as coarser cuts know: 0 or 1 where no cut passes through
  // its ancestors, otherwise the share of the three faces of its parent that
  // it touches.
  float InsideFraction(const Eigen::Vector3i& voxel, int level) const;

 private:
  std::vector<LabeledCrust> levels_;
};

}  // namespace octacut
