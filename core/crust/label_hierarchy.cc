#include "core/crust/label_hierarchy.h"

#include "core/base/error.h"

namespace octacut {

void LabelHierarchy::Add(LabeledVoxels level) {
  if (level.labels.size() != level.voxels.Size() ||
      (!Empty() && level.voxels.Level() != Finest().voxels.Level() + 1)) {
    throw InvariantError("a label hierarchy grows by one labelled level");
  }
  levels_.push_back(std::move(level));
}

float LabelHierarchy::InsideFraction(const Eigen::Vector3i& voxel,
                                     int level) const {
  for (size_t i = levels_.size(); i-- > 0;) {
    const LabeledVoxels& labeled = levels_[i];
    const int up = level - labeled.voxels.Level();
    if (up <= 0) {
      continue;
    }
    const Eigen::Vector3i parent(
        voxel.x() >> up, voxel.y() >> up, voxel.z() >> up);
    const VoxelGrid::Index index = labeled.voxels.Find(parent);
    if (index != VoxelGrid::kNone) {
      const FaceLabels labels = labeled.labels[index];
      const Eigen::Vector3i child(
          voxel.x() >> (up - 1), voxel.y() >> (up - 1), voxel.z() >> (up - 1));
      int inside = 0;
      for (int axis = 0; axis < 3; ++axis) {
        inside += (labels >> (2 * axis + (child[axis] & 1))) & 1;
      }
      return float(inside) / 3;
    }
  }
  return 0;
}

}  // namespace octacut
