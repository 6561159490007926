#include "core/grid/voxel_walk.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace octacut {

VoxelWalk::VoxelWalk(const VoxelGrid& grid, const Context& context)
    : ranks_(grid.Bricks().size() + 1), links_(grid.Bricks().size() + 1) {
  constexpr size_t kBrickGrain = 2048;
  const size_t num_bricks = grid.Bricks().size();
  ParallelFor(context, num_bricks, kBrickGrain, [&](size_t begin, size_t end) {
    EnterBricks(grid, begin, end);
  });
  std::fill_n(links_[num_bricks].brick, kNumFaces + 1, uint32_t(num_bricks));
  links_[num_bricks].first = uint32_t(grid.Size());
  std::fill_n(ranks_[num_bricks].rank, 64, kEmpty);
  // A brick has one neighbour a face, so that no link is set twice.
  ParallelFor(context, num_bricks, kBrickGrain, [&](size_t begin, size_t end) {
    LinkBricks(grid, begin, end);
  });
}

void VoxelWalk::EnterBricks(const VoxelGrid& grid, size_t begin, size_t end) {
  for (size_t b = begin; b < end; ++b) {
    const VoxelGrid::Brick& brick = grid.Bricks()[b];
    std::fill_n(links_[b].brick, kNumFaces, uint32_t(grid.Bricks().size()));
    links_[b].brick[kNumFaces] = uint32_t(b);
    links_[b].first = brick.first;
    uint8_t rank = 0;
    for (int bit = 0; bit < 64; ++bit) {
      const bool is_voxel = (brick.mask >> bit) & 1;
      ranks_[b].rank[bit] = is_voxel ? rank : kEmpty;
      rank += is_voxel;
    }
  }
}

void VoxelWalk::LinkBricks(const VoxelGrid& grid, size_t begin, size_t end) {
  for (size_t b = begin; b < end; ++b) {
    const Eigen::Vector3i position = DecodeMorton(grid.Bricks()[b].key);
    for (int face = 0; face < kNumFaces; face += 2) {
      const VoxelGrid::Index below =
          position[face / 2] == 0
              ? VoxelGrid::kNone
              : grid.FindBrick(EncodeMorton(NeighborVoxel(position, face)));
      if (below != VoxelGrid::kNone) {
        links_[b].brick[face] = below;
        links_[below].brick[face + 1] = uint32_t(b);
      }
    }
  }
}

std::vector<float> VoxelWalk::SumOverBrickNeighbors(
    const std::vector<float>& values) const {
  std::vector<float> sums = values;
  for (size_t b = 0; b < NumBricks(); ++b) {
    for (int face = 0; face < kNumFaces; ++face) {
      const size_t beside = BrickBeside(b, face);
      if (beside < NumBricks()) {
        sums[b] += values[beside];
      }
    }
  }
  return sums;
}

}  // namespace octacut
