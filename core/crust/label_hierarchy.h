// The labellings of all levels so far. A level's cut decides only within its
// crust; whether a voxel outside of the crust is inside or outside the object
// is known from the first coarser level whose crust holds its ancestor.
#pragma once

#include <vector>

#include "core/grid/labeled_voxels.h"

namespace octacut {

class LabelHierarchy {
 public:
  // Levels are added from coarse to fine, each one level finer.
  void Add(LabeledVoxels level);
  bool Empty() const { return levels_.empty(); }
  const LabeledVoxels& Finest() const { return levels_.back(); }

  // Share of the voxel (one level finer than Finest() or coarser) that is
  // inside, as far as coarser cuts know: 0 or 1 where no cut passes through
  // its ancestors, otherwise the share of the three faces of its parent that
  // it touches.
  float InsideFraction(const Eigen::Vector3i& voxel, int level) const;

 private:
  std::vector<LabeledVoxels> levels_;
};

}  // namespace octacut
