#include "core/cut/voxel_walk.h"

#include <algorithm>

namespace octacut {

VoxelWalk::VoxelWalk(const VoxelGrid& grid)
    : ranks_(grid.Bricks().size() + 1), links_(grid.Bricks().size() + 1) {
  const uint32_t num_bricks = uint32_t(grid.Bricks().size());
  const int resolution = (grid.Resolution() + 3) / 4;
  for (uint32_t b = 0; b < num_bricks; ++b) {
    const VoxelGrid::Brick& brick = grid.Bricks()[b];
    const Eigen::Vector3i position = DecodeMorton(brick.key);
    for (int face = 0; face < kNumFaces; ++face) {
      const Eigen::Vector3i next = NeighborVoxel(position, face);
      const int coordinate = next[face / 2];
      const VoxelGrid::Index beside = coordinate < 0 || coordinate >= resolution
                                          ? VoxelGrid::kNone
                                          : grid.FindBrick(EncodeMorton(next));
      links_[b].brick[face] = beside == VoxelGrid::kNone ? num_bricks : beside;
    }
    links_[b].brick[kNumFaces] = b;
    links_[b].first = brick.first;
    uint8_t rank = 0;
    for (int bit = 0; bit < 64; ++bit) {
      ranks_[b].rank[bit] = (brick.mask >> bit) & 1 ? rank++ : kEmpty;
    }
  }
  std::fill_n(links_[num_bricks].brick, kNumFaces + 1, num_bricks);
  links_[num_bricks].first = uint32_t(grid.Size());
  std::fill_n(ranks_[num_bricks].rank, 64, kEmpty);
}

}  // namespace octacut
