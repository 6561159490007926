#include "core/extract/cut_voxels.h"

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
    size_ += CountBits(cut);
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

namespace {

// Voxels of a neighbouring brick that touch the central one, for each side of
// it (27 of them, x fastest), as a brick's mask.
constexpr std::array<uint64_t, 27> TouchingMasks() {
  std::array<uint64_t, 27> masks{};
  for (int side = 0; side < 27; ++side) {
    const int sides[3] = {side % 3 - 1, side / 3 % 3 - 1, side / 9 - 1};
    for (int bit = 0; bit < 64; ++bit) {
      bool touches = true;
      for (int axis = 0; axis < 3; ++axis) {
        const int at = CoordinateInBrick(bit, axis);
        touches &= sides[axis] == 0 || at == (sides[axis] < 0 ? 3 : 0);
      }
      masks[side] |= uint64_t{touches} << bit;
    }
  }
  return masks;
}

// Cells of a brick's voxels in a block, for the central brick.
constexpr std::array<int16_t, 64> CellsOfBits() {
  std::array<int16_t, 64> cells{};
  for (int bit = 0; bit < 64; ++bit) {
    cells[bit] = int16_t(CutBlock::Cell(CoordinateInBrick(bit, 0),
                                        CoordinateInBrick(bit, 1),
                                        CoordinateInBrick(bit, 2)));
  }
  return cells;
}

constexpr std::array<uint64_t, 27> kTouchingMasks = TouchingMasks();
constexpr std::array<int16_t, 64> kCellsOfBits = CellsOfBits();

}  // namespace

void CutBlock::Load(const CutVoxels& cut, size_t brick) {
  labels_.fill(kUnknown);
  numbers_.fill(CutVoxels::kNone);
  const Eigen::Vector3i center = DecodeMorton(cut.Crust().Bricks()[brick].key);
  for (int side = 0; side < 27; ++side) {
    const Eigen::Vector3i step(side % 3 - 1, side / 3 % 3 - 1, side / 9 - 1);
    const Eigen::Vector3i other = center + step;
    if ((other.array() < 0).any()) {
      continue;
    }
    const CutVoxels::Index found =
        side == 13 ? CutVoxels::Index(brick)
                   : cut.Crust().FindBrick(EncodeMorton(other));
    if (found != CutVoxels::kNone) {
      LoadFrom(cut,
               found,
               kTouchingMasks[side],
               4 * (step.x() + kSide * (step.y() + kSide * step.z())));
    }
  }
}

void CutBlock::LoadFrom(const CutVoxels& cut,
                        size_t brick,
                        uint64_t touching,
                        int shift) {
  const VoxelGrid::Brick& bits = cut.Crust().Bricks()[brick];
  const uint64_t cut_mask = cut.Mask(brick);
  for (uint64_t rest = bits.mask & touching; rest != 0; rest &= rest - 1) {
    const uint64_t below = (rest & (~rest + 1)) - 1;
    const int bit = std::countr_zero(rest);
    const int cell = kCellsOfBits[bit] + shift;
    labels_[cell] = cut.CrustLabels(
        bits.first + CutVoxels::Index(CountBits(bits.mask & below)));
    if (cut_mask >> bit & 1) {
      numbers_[cell] =
          cut.First(brick) + CutVoxels::Index(CountBits(cut_mask & below));
    }
  }
}

}  // namespace octacut
