#include "core/mesh/cut_voxels.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace octacut {

CutVoxels::CutVoxels(const VoxelGrid& crust, std::span<const FaceLabels> labels)
    : crust_(&crust),
      labels_(labels),
      masks_(crust.Bricks().size()),
      first_(crust.Bricks().size()) {
  for (size_t b = 0; b < masks_.size(); ++b) {
    const VoxelGrid::Brick& brick = crust.Bricks()[b];
    Index index = brick.first;
    uint64_t cut = 0;
    for (uint64_t mask = brick.mask; mask != 0; mask &= mask - 1) {
      const FaceLabels of_voxel = labels[index++];
      if (of_voxel > kAllFaces) {
        throw InputError(
            fmt::format("face labels {:#x} of voxel {}: only the "
                        "lowest six bits may be set",
                        of_voxel,
                        index - 1));
      }
      if (IsCut(of_voxel)) {
        cut |= mask & (~mask + 1);
      }
    }
    masks_[b] = cut;
    first_[b] = Index(size_);
    size_ += std::popcount(cut);
  }
}

CutVoxels::Hit CutVoxels::Find(const Eigen::Vector3i& voxel) const {
  const int resolution = crust_->Resolution();
  if ((voxel.array() < 0).any() || (voxel.array() >= resolution).any()) {
    return {};
  }
  const MortonCode code = EncodeMorton(voxel);
  const Index brick = crust_->FindBrick(code >> 6);
  const int bit = int(code & 63);
  if (brick == kNone || (masks_[brick] >> bit & 1) == 0) {
    return {};
  }
  return {NumberInBrick(brick, bit), labels_[crust_->FindInBrick(brick, bit)]};
}

CutVoxels::Hit CutVoxels::FindAcross(const Eigen::Vector3i& voxel,
                                     int k,
                                     unsigned axes) const {
  Eigen::Vector3i other = voxel;
  for (int axis = 0; axis < 3; ++axis) {
    if (axes >> axis & 1) {
      other[axis] += (k >> axis & 1) ? 1 : -1;
    }
  }
  return Find(other);
}

void CutBlock::Load(const CutVoxels& cut, size_t brick) {
  labels_.fill(kUnknown);
  numbers_.fill(CutVoxels::kNone);
  const uint64_t key = cut.Crust().Bricks()[brick].key;
  const Eigen::Vector3i center = DecodeMorton(key);
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const Eigen::Vector3i side(x, y, z);
        const Eigen::Vector3i other = center + side;
        if ((other.array() < 0).any()) {
          continue;
        }
        const CutVoxels::Index found =
            cut.Crust().FindBrick(EncodeMorton(other));
        if (found != CutVoxels::kNone) {
          LoadFrom(cut, found, side);
        }
      }
    }
  }
}

void CutBlock::LoadFrom(const CutVoxels& cut,
                        size_t brick,
                        const Eigen::Vector3i& side) {
  // Of the brick at `side` only the layer next to the central one is seen.
  Eigen::Vector3i low;
  Eigen::Vector3i high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = side[axis] < 0 ? 3 : 0;
    high[axis] = side[axis] > 0 ? 0 : 3;
  }
  const CutVoxels::Index number = CutVoxels::Index(brick);
  for (int z = low.z(); z <= high.z(); ++z) {
    for (int y = low.y(); y <= high.y(); ++y) {
      for (int x = low.x(); x <= high.x(); ++x) {
        const int bit = int(EncodeMorton(x, y, z));
        const CutVoxels::Index crust_index =
            cut.Crust().FindInBrick(number, bit);
        if (crust_index == CutVoxels::kNone) {
          continue;
        }
        const int cell =
            Cell(x + 4 * side.x(), y + 4 * side.y(), z + 4 * side.z());
        labels_[cell] = cut.CrustLabels(crust_index);
        if (cut.Mask(brick) >> bit & 1) {
          numbers_[cell] = cut.NumberInBrick(brick, bit);
        }
      }
    }
  }
}

}  // namespace octacut
