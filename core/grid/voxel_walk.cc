#include "core/grid/voxel_walk.h"

#include <algorithm>

namespace octacut {

VoxelWalk::VoxelWalk(const VoxelGrid& grid)
    : ranks_(grid.Bricks().size() + 1), links_(grid.Bricks().size() + 1) {
  const uint32_t num_bricks = uint32_t(grid.Bricks().size());
  for (uint32_t b = 0; b <= num_bricks; ++b) {
    std::fill_n(links_[b].brick, kNumFaces, num_bricks);
    links_[b].brick[kNumFaces] = b;
  }
  for (uint32_t b = 0; b < num_bricks; ++b) {
    const VoxelGrid::Brick& brick = grid.Bricks()[b];
    const Eigen::Vector3i position = DecodeMorton(brick.key);
    for (int face = 0; face < kNumFaces; face += 2) {
      const VoxelGrid::Index below =
          position[face / 2] == 0
              ? VoxelGrid::kNone
              : grid.FindBrick(EncodeMorton(NeighborVoxel(position, face)));
      if (below != VoxelGrid::kNone) {
        links_[b].brick[face] = below;
        links_[below].brick[face + 1] = b;
      }
    }
    links_[b].first = brick.first;
    uint8_t rank = 0;
    for (int bit = 0; bit < 64; ++bit) {
      ranks_[b].rank[bit] = (brick.mask >> bit) & 1 ? rank++ : kEmpty;
    }
  }
  links_[num_bricks].first = uint32_t(grid.Size());
  std::fill_n(ranks_[num_bricks].rank, 64, kEmpty);
}

}  // namespace octacut
