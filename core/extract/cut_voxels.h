// The cut voxels of a labelled crust, numbered 0 .. n - 1 in Morton order,
// and what of them lies around a brick. For core/extract alone.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/grid/count_bits.h"
#include "core/grid/face.h"
#include "core/grid/voxel_grid.h"

namespace octacut {

class CutVoxels {
 public:
  using Index = VoxelGrid::Index;
  static constexpr Index kNone = VoxelGrid::kNone;

  // Keeps references to both. `labels` has one element per voxel of `crust`.
  CutVoxels(const VoxelGrid& crust, std::span<const FaceLabels> labels);

  size_t Size() const { return size_; }
  const VoxelGrid& Crust() const { return *crust_; }
  // Labels of a voxel of the crust.
  FaceLabels CrustLabels(Index crust_index) const {
    return labels_[crust_index];
  }
  // Cut voxels of a brick of the crust, and the number of the first of them.
  uint64_t Mask(size_t brick) const { return masks_[brick]; }
  Index First(size_t brick) const { return first_[brick]; }
  Index NumberInBrick(size_t brick, int bit) const {
    return first_[brick] +
           Index(CountBits(masks_[brick] & ((uint64_t{1} << bit) - 1)));
  }

  // Number and labels of the cut voxel at `voxel`; kNone when it is not cut.
  struct Hit {
    Index number = kNone;
    FaceLabels labels = 0;
  };
  Hit Find(const Eigen::Vector3i& voxel) const;
  // The same for the voxel on the other side of the faces that `voxel` has at
  // its corner `k` across each of `axes` (a bit mask).
  Hit FindAcross(const Eigen::Vector3i& voxel, int k, unsigned axes) const;

  // Calls body(number, bit, labels) for the cut voxels of a brick in order.
  template <typename Body>
  void ForEachInBrick(size_t brick, Body&& body) const {
    Index number = first_[brick];
    const VoxelGrid::Brick& bits = crust_->Bricks()[brick];
    Index index = bits.first;
    for (uint64_t mask = bits.mask; mask != 0; mask &= mask - 1, ++index) {
      if (IsCut(labels_[index])) {
        body(number++, std::countr_zero(mask), labels_[index]);
      }
    }
  }

 private:
  const VoxelGrid* crust_;
  std::span<const FaceLabels> labels_;
  std::vector<uint64_t> masks_;
  std::vector<Index> first_;
  size_t size_ = 0;
};

// Coordinate of the voxel at `bit` of a brick within the brick.
inline constexpr int CoordinateInBrick(int bit, int axis) {
  return (bit >> axis & 1) | (bit >> (axis + 2) & 2);
}

// The 6^3 voxels in and around a brick as a dense array.
class CutBlock {
 public:
  static constexpr int kSide = 6;
  static constexpr uint8_t kUnknown = 0xff;  // no voxel of the crust

  void Load(const CutVoxels& cut, size_t brick);

  // Cell of a voxel whose coordinates within the brick are -1 .. 4.
  static constexpr int Cell(int x, int y, int z) {
    return (x + 1) + kSide * ((y + 1) + kSide * (z + 1));
  }
  uint8_t Labels(int cell) const { return labels_[cell]; }
  // kNone for voxels that are not cut.
  CutVoxels::Index Number(int cell) const { return numbers_[cell]; }

 private:
  // Loads the voxels of a brick that are in `touching`; `shift` is the way
  // of their cells from those of the central brick.
  void LoadFrom(const CutVoxels& cut,
                size_t brick,
                uint64_t touching,
                int shift);

  static constexpr size_t kNumCells = size_t{kSide} * kSide * kSide;

  std::array<uint8_t, kNumCells> labels_;
  std::array<CutVoxels::Index, kNumCells> numbers_;
};

}  // namespace octacut
