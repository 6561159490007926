// A sparse set of voxels of one level, in Morton order, packed in 4^3 bricks.
//
// Voxel i of the set owns element i of every per-voxel array, so those are
// plain vectors with neither gaps nor keys. A brick holds a 64-bit occupancy
// mask whose bits are in Morton order, and the number of voxels before it.
// Bricks are found through an open-addressing hash table: some 1.5 bytes a
// voxel in all for crusts (see docs/method.md).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/morton.h"
#include "core/grid/count_bits.h"
#include "core/grid/face.h"

namespace octacut {

class VoxelGrid {
 public:
  using Index = uint32_t;
  static constexpr Index kNone = 0xffffffffu;

  struct Brick {
    uint64_t key;   // Morton code of the brick: voxel code >> 6
    uint64_t mask;  // occupancy in Morton order
    Index first;    // index of the brick's first voxel
  };

  VoxelGrid() = default;
  // `codes` need be neither sorted nor unique.
  static VoxelGrid FromCodes(int level, std::vector<MortonCode> codes);
  // `bricks` sorted by key, no empty mask; `first` is filled in.
  static VoxelGrid FromBricks(int level, std::vector<Brick> bricks);

  int Level() const { return level_; }
  // Voxels along each edge of the root cube.
  int Resolution() const { return 1 << level_; }
  size_t Size() const { return size_; }
  bool Empty() const { return size_ == 0; }
  const std::vector<Brick>& Bricks() const { return bricks_; }
  size_t MemoryBytes() const;

  // Index of a voxel or kNone; coordinates outside the root cube are legal
  // and never in the set.
  Index Find(MortonCode code) const {
    const Index brick = FindBrick(code >> 6);
    return brick == kNone ? kNone : FindInBrick(brick, int(code & 63));
  }
  Index Find(const Eigen::Vector3i& voxel) const {
    const int resolution = Resolution();
    if ((voxel.array() < 0).any() || (voxel.array() >= resolution).any()) {
      return kNone;
    }
    return Find(EncodeMorton(voxel));
  }
  // That of the voxel that holds a point, unit coordinates.
  Index FindAt(const Eigen::Vector3f& point) const {
    return Find(Eigen::Vector3i(
        (point * float(Resolution())).array().floor().cast<int>()));
  }
  bool Contains(const Eigen::Vector3i& voxel) const {
    return Find(voxel) != kNone;
  }

  // Number of a brick in Bricks(), or kNone.
  Index FindBrick(uint64_t key) const;
  // Index of the voxel at `bit` of a brick, or kNone.
  Index FindInBrick(Index brick, int bit) const {
    const uint64_t mask = bricks_[brick].mask;
    if (((mask >> bit) & 1) == 0) {
      return kNone;
    }
    return bricks_[brick].first +
           Index(CountBits(mask & ((uint64_t{1} << bit) - 1)));
  }

  // Calls body(index, Morton code) in Morton order for the voxels of
  // bricks [begin, end).
  template <typename Body>
  void ForEachInBricks(size_t begin, size_t end, Body&& body) const {
    for (size_t b = begin; b < end; ++b) {
      Index index = bricks_[b].first;
      for (uint64_t mask = bricks_[b].mask; mask != 0; mask &= mask - 1) {
        body(index++, CodeOf(bricks_[b], std::countr_zero(mask)));
      }
    }
  }
  template <typename Body>
  void ForEach(Body&& body) const {
    ForEachInBricks(0, bricks_.size(), body);
  }

  static MortonCode CodeOf(const Brick& brick, int bit) {
    return brick.key << 6 | uint64_t(bit);
  }

 private:
  int level_ = 0;
  size_t size_ = 0;
  std::vector<Brick> bricks_;
  std::vector<Index> table_;  // open addressing, kNone = free
};

// The voxel across face `face`; may lie outside the root cube.
inline Eigen::Vector3i NeighborVoxel(Eigen::Vector3i voxel, int face) {
  voxel[face / 2] += (face & 1) ? 1 : -1;
  return voxel;
}

}  // namespace octacut
