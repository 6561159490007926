// Neighbours of voxels by bit arithmetic inside a brick and one look-up for
// each of a brick's six neighbours, instead of a hash look-up a voxel.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "core/grid/voxel_grid.h"

namespace octacut {

// Bits of a position inside a brick (Morton, 6 bits) that hold one axis.
inline constexpr int kBrickAxisBits[3] = {0b001001, 0b010010, 0b100100};

// Position across face `face`, wrapped into the neighbouring brick.
inline constexpr int StepInBrick(int bit, int face) {
  const int axis = kBrickAxisBits[face / 2];
  const int moved = (face & 1) ? ((bit | ~axis) + (axis & -axis))
                               : ((bit & axis) - (axis & -axis));
  return (bit & ~axis & 63) | (moved & axis);
}

// Whether the step across `face` leaves the brick.
inline constexpr bool LeavesBrick(int bit, int face) {
  const int axis = kBrickAxisBits[face / 2];
  return (bit & axis) == ((face & 1) ? axis : 0);
}

struct BrickSteps {
  uint8_t to[kNumFaces][64] = {};   // StepInBrick
  uint64_t leaves[kNumFaces] = {};  // bit b: LeavesBrick(b)
};

inline constexpr BrickSteps MakeBrickSteps() {
  BrickSteps steps;
  for (int face = 0; face < kNumFaces; ++face) {
    for (int bit = 0; bit < 64; ++bit) {
      steps.to[face][bit] = uint8_t(StepInBrick(bit, face));
      if (LeavesBrick(bit, face)) {
        steps.leaves[face] |= uint64_t{1} << bit;
      }
    }
  }
  return steps;
}
inline constexpr BrickSteps kBrickSteps = MakeBrickSteps();

// Numbers of the six neighbouring bricks, kNone where there is none.
inline std::array<VoxelGrid::Index, kNumFaces> NeighborBricks(
    const VoxelGrid& grid, VoxelGrid::Index brick) {
  std::array<VoxelGrid::Index, kNumFaces> neighbors;
  const Eigen::Vector3i position = DecodeMorton(grid.Bricks()[brick].key);
  const int resolution = (grid.Resolution() + 3) / 4;
  for (int face = 0; face < kNumFaces; ++face) {
    const Eigen::Vector3i next = NeighborVoxel(position, face);
    const int coordinate = next[face / 2];
    neighbors[face] = coordinate < 0 || coordinate >= resolution
                          ? VoxelGrid::kNone
                          : grid.FindBrick(EncodeMorton(next));
  }
  return neighbors;
}

// Index of the voxel across `face` of the voxel at `bit` of `brick`, whose
// neighbours are `neighbors`; kNone where there is none.
inline VoxelGrid::Index NeighborIndex(
    const VoxelGrid& grid,
    VoxelGrid::Index brick,
    const std::array<VoxelGrid::Index, kNumFaces>& neighbors,
    int bit,
    int face) {
  const VoxelGrid::Index owner =
      (kBrickSteps.leaves[face] >> bit) & 1 ? neighbors[face] : brick;
  return owner == VoxelGrid::kNone
             ? VoxelGrid::kNone
             : grid.FindInBrick(owner, kBrickSteps.to[face][bit]);
}

// Calls body(index, code, neighbors) in Morton order for the voxels of bricks
// [begin, end); neighbors[f] is the index across face f or kNone.
template <typename Body>
void ForEachWithNeighbors(const VoxelGrid& grid,
                          size_t begin,
                          size_t end,
                          Body&& body) {
  for (size_t b = begin; b < end; ++b) {
    const VoxelGrid::Brick& brick = grid.Bricks()[b];
    const auto bricks = NeighborBricks(grid, VoxelGrid::Index(b));
    VoxelGrid::Index index = brick.first;
    for (uint64_t mask = brick.mask; mask != 0; mask &= mask - 1) {
      const int bit = std::countr_zero(mask);
      std::array<VoxelGrid::Index, kNumFaces> neighbors;
      for (int face = 0; face < kNumFaces; ++face) {
        neighbors[face] =
            NeighborIndex(grid, VoxelGrid::Index(b), bricks, bit, face);
      }
      body(index++, VoxelGrid::CodeOf(brick, bit), neighbors);
    }
  }
}

}  // namespace octacut
