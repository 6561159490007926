#include "core/grid/voxel_grid.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"

namespace octacut {
namespace {

uint64_t HashKey(uint64_t key) {
  // Fibonacci hashing: the high bits of the product are well mixed.
  return (key * 0x9e3779b97f4a7c15ull) >> 20;
}

}  // namespace

VoxelGrid VoxelGrid::FromCodes(int level, std::vector<MortonCode> codes) {
  std::sort(codes.begin(), codes.end());
  std::vector<Brick> bricks;
  for (const MortonCode code : codes) {
    if (bricks.empty() || bricks.back().key != code >> 6) {
      bricks.push_back({code >> 6, 0, 0});
    }
    bricks.back().mask |= uint64_t{1} << (code & 63);
  }
  return FromBricks(level, std::move(bricks));
}

VoxelGrid VoxelGrid::FromBricks(int level, std::vector<Brick> bricks) {
  VoxelGrid grid;
  grid.level_ = level;
  grid.bricks_ = std::move(bricks);
  for (Brick& brick : grid.bricks_) {
    if (grid.size_ >= kNone - 64) {
      throw Error(fmt::format(
          "a grid of level {} holds more than {} voxels", level, kNone - 64));
    }
    brick.first = Index(grid.size_);
    grid.size_ += CountBits(brick.mask);
  }
  if (!grid.bricks_.empty()) {
    grid.table_.assign(std::bit_ceil(grid.bricks_.size() * 2), kNone);
    const size_t wrap = grid.table_.size() - 1;
    for (Index b = 0; b < grid.bricks_.size(); ++b) {
      size_t slot = HashKey(grid.bricks_[b].key) & wrap;
      while (grid.table_[slot] != kNone) {
        slot = (slot + 1) & wrap;
      }
      grid.table_[slot] = b;
    }
  }
  return grid;
}

VoxelGrid::Index VoxelGrid::FindBrick(uint64_t key) const {
  if (table_.empty()) {
    return kNone;
  }
  const size_t wrap = table_.size() - 1;
  for (size_t slot = HashKey(key) & wrap;; slot = (slot + 1) & wrap) {
    const Index brick = table_[slot];
    if (brick == kNone || bricks_[brick].key == key) {
      return brick;
    }
  }
}

size_t VoxelGrid::MemoryBytes() const {
  return bricks_.capacity() * sizeof(Brick) + table_.capacity() * sizeof(Index);
}

}  // namespace octacut
