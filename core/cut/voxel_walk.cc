#include "core/cut/voxel_walk.h"

namespace octacut {

VoxelWalk::VoxelWalk(const VoxelGrid& grid)
    : ranks_(grid.Bricks().size()), links_(grid.Bricks().size()) {
  const int resolution = (grid.Resolution() + 3) / 4;
  for (size_t b = 0; b < links_.size(); ++b) {
    const VoxelGrid::Brick& brick = grid.Bricks()[b];
    const Eigen::Vector3i position = DecodeMorton(brick.key);
    for (int face = 0; face < kNumFaces; ++face) {
      const Eigen::Vector3i next = NeighborVoxel(position, face);
      const int coordinate = next[face / 2];
      links_[b].brick[face] = coordinate < 0 || coordinate >= resolution
                                  ? VoxelGrid::kNone
                                  : grid.FindBrick(EncodeMorton(next));
    }
    links_[b].brick[kNumFaces] = uint32_t(b);
    links_[b].first = brick.first;
    uint8_t rank = 0;
    for (int bit = 0; bit < 64; ++bit) {
      ranks_[b].rank[bit] = (brick.mask >> bit) & 1 ? rank++ : kEmpty;
    }
  }
}

}  // namespace octacut
