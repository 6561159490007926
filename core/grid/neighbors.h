// Face neighbours of voxels of a grid, found brick by brick: the six
// neighbouring bricks are looked up once for all 64 voxels of a brick.
#pragma once

#include <array>
#include <bit>

#include "core/grid/voxel_grid.h"

namespace octacut {

using NeighborIndices = std::array<VoxelGrid::Index, kNumFaces>;

class BrickNeighborhood {
 public:
  BrickNeighborhood(const VoxelGrid& grid, size_t brick)
      : grid_(grid), brick_(VoxelGrid::Index(brick)) {
    const Eigen::Vector3i position = DecodeMorton(grid.Bricks()[brick].key);
    const int extent = (grid.Resolution() + 3) / 4;
    for (int face = 0; face < kNumFaces; ++face) {
      const Eigen::Vector3i other = NeighborVoxel(position, face);
      bricks_[face] =
          (other.array() < 0).any() || (other.array() >= extent).any()
              ? VoxelGrid::kNone
              : grid.FindBrick(EncodeMorton(other));
    }
  }

  // Indices of the six face neighbours of the voxel at `bit`; kNone where
  // there is none in the grid.
  NeighborIndices Of(int bit) const {
    NeighborIndices result;
    for (int face = 0; face < kNumFaces; ++face) {
      const int axis = face / 2;
      const int low = 1 << axis;
      const int high = 8 << axis;
      const int coordinate = ((bit & low) ? 1 : 0) + ((bit & high) ? 2 : 0);
      const int moved = coordinate + ((face & 1) ? 1 : -1);
      const int wrapped = moved & 3;
      const int target = (bit & ~(low | high)) | ((wrapped & 1) ? low : 0) |
                         ((wrapped & 2) ? high : 0);
      const VoxelGrid::Index brick = moved == wrapped ? brick_ : bricks_[face];
      result[face] = brick == VoxelGrid::kNone
                         ? VoxelGrid::kNone
                         : grid_.FindInBrick(brick, target);
    }
    return result;
  }

 private:
  const VoxelGrid& grid_;
  VoxelGrid::Index brick_;
  std::array<VoxelGrid::Index, kNumFaces> bricks_;
};

// Calls body(index, code, neighbours) for the voxels of bricks [begin, end).
template <typename Body>
void ForEachWithNeighbors(const VoxelGrid& grid,
                          size_t begin,
                          size_t end,
                          Body&& body) {
  for (size_t b = begin; b < end; ++b) {
    const VoxelGrid::Brick& brick = grid.Bricks()[b];
    const BrickNeighborhood neighborhood(grid, b);
    VoxelGrid::Index index = brick.first;
    for (uint64_t mask = brick.mask; mask != 0; mask &= mask - 1, ++index) {
      const int bit = std::countr_zero(mask);
      body(index, VoxelGrid::CodeOf(brick, bit), neighborhood.Of(bit));
    }
  }
}

}  // namespace octacut
