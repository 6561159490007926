// Stepping between face-adjacent voxels of a crust without a neighbour table.
//
// A voxel is addressed by a slot: its brick and its position in it, which
// two small tables per brick turn into the voxel's index and into the slots
// beside it. Some 3 bytes per voxel; a neighbour table would take 24.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/grid/voxel_grid.h"

namespace octacut {

struct VoxelSlot {
  uint32_t brick;
  uint32_t bit;    // position in the brick, 0 .. 63
  uint32_t index;  // of the voxel in per-voxel arrays
};

class VoxelWalk {
 public:
  using Index = VoxelGrid::Index;

  VoxelWalk(const VoxelGrid& grid, const Context& context);

  size_t NumBricks() const { return links_.size() - 1; }
  static constexpr size_t kBytesPerBrick = 64 + 32;

  // Number of voxels in the bricks before `brick`, which may be the end.
  uint32_t FirstVoxelOrEnd(size_t brick) const { return links_[brick].first; }
  // The brick across a face of a brick, NumBricks() where there is none.
  uint32_t BrickBeside(size_t brick, int face) const {
    return links_[brick].brick[face];
  }

  // A voxel of the crust.
  VoxelSlot At(uint32_t brick, uint32_t bit) const {
    return {brick, bit, links_[brick].first + ranks_[brick].rank[bit]};
  }

  // The voxel across `face`; `face` = kNumFaces stays. Where there is none, a
  // place whose index must not be used.
  VoxelSlot Step(const VoxelSlot& from, int face) const {
    const BrickStep step = kSteps[face][from.bit];
    return At(links_[from.brick].brick[step.link], step.bit);
  }

  // The brick across `face` of a voxel, which may be its own; NumBricks()
  // where there is none.
  uint32_t StepBrick(const VoxelSlot& from, int face) const {
    return links_[from.brick].brick[kSteps[face][from.bit].link];
  }

  // Index of the voxel across `face`, kNone where there is none.
  Index Neighbor(const VoxelSlot& from, int face) const {
    const BrickStep step = kSteps[face][from.bit];
    const uint32_t brick = links_[from.brick].brick[step.link];
    const uint8_t rank = ranks_[brick].rank[step.bit];
    return rank == kEmpty ? VoxelGrid::kNone : links_[brick].first + rank;
  }

  // For each brick the sum of its value and those of the bricks beside it.
  std::vector<float> SumOverBrickNeighbors(
      const std::vector<float>& values) const;

  // Calls body(slot, neighbors) in order for the voxels of bricks
  // [begin, end); neighbors[f] is the index across face f or kNone.
  template <typename Body>
  void ForEachWithNeighbors(size_t begin, size_t end, Body&& body) const {
    std::array<Index, kNumFaces> neighbors;
    ForEach(begin, end, [&](const VoxelSlot& slot) {
      for (int face = 0; face < kNumFaces; ++face) {
        neighbors[face] = Neighbor(slot, face);
      }
      body(slot, neighbors);
    });
  }

  // Calls body(slot) in order for the voxels of bricks [begin, end).
  template <typename Body>
  void ForEach(size_t begin, size_t end, Body&& body) const {
    for (size_t b = begin; b < end; ++b) {
      uint32_t index = links_[b].first;
      for (uint32_t bit = 0; bit < 64; ++bit) {
        if (ranks_[b].rank[bit] != kEmpty) {
          body(VoxelSlot{uint32_t(b), bit, index++});
        }
      }
    }
  }

 private:
  // Enters the bricks [begin, end) of a grid, without links.
  void EnterBricks(const VoxelGrid& grid, size_t begin, size_t end);
  // Enters their links downwards, and those of the bricks below to them.
  void LinkBricks(const VoxelGrid& grid, size_t begin, size_t end);

  static constexpr uint8_t kEmpty = 0xff;

  struct alignas(64) Ranks {
    uint8_t rank[64];  // of each position among the brick's voxels, or kEmpty
  };
  struct alignas(32) Links {
    uint32_t brick[kNumFaces + 1];  // beside each face; the last is itself
    uint32_t first;                 // index of the brick's first voxel
  };
  struct BrickStep {
    uint8_t bit;   // position after the step
    uint8_t link;  // entry of Links::brick
  };
  using BrickSteps = std::array<std::array<BrickStep, 64>, kNumFaces + 1>;
  static constexpr BrickSteps MakeSteps();
  static const BrickSteps kSteps;

  // With an empty brick at the end, which stands for all that are missing.
  std::vector<Ranks> ranks_;
  std::vector<Links> links_;
};

// Positions in a brick are Morton codes of 6 bits: those of one axis.
inline constexpr int kBrickAxisBits[3] = {0b001001, 0b010010, 0b100100};

// Position across `face`, wrapped into the neighbouring brick.
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

constexpr VoxelWalk::BrickSteps VoxelWalk::MakeSteps() {
  BrickSteps steps = {};
  for (int bit = 0; bit < 64; ++bit) {
    for (int face = 0; face < kNumFaces; ++face) {
      steps[face][bit] = {uint8_t(StepInBrick(bit, face)),
                          uint8_t(LeavesBrick(bit, face) ? face : kNumFaces)};
    }
    steps[kNumFaces][bit] = {uint8_t(bit), kNumFaces};
  }
  return steps;
}

inline constexpr VoxelWalk::BrickSteps VoxelWalk::kSteps =
    VoxelWalk::MakeSteps();

}  // namespace octacut
