#include "core/grid/morphology.h"

#include <algorithm>

#include "core/base/error.h"

namespace octacut {
namespace {

using Brick = VoxelGrid::Brick;

// Bits of a brick's mask with coordinate `value` along an axis: bits 0 and 3
// of the in-brick Morton code are x, 1 and 4 are y, 2 and 5 are z.
constexpr uint64_t LayerMask(int axis, int value) {
  uint64_t mask = 0;
  for (int bit = 0; bit < 64; ++bit) {
    const int coordinate = ((bit >> axis) & 1) | ((bit >> (axis + 3)) & 1) << 1;
    if (coordinate == value) {
      mask |= uint64_t{1} << bit;
    }
  }
  return mask;
}

struct AxisMasks {
  uint64_t layer[4];
};
constexpr AxisMasks kAxisMasks[3] = {
    {{LayerMask(0, 0), LayerMask(0, 1), LayerMask(0, 2), LayerMask(0, 3)}},
    {{LayerMask(1, 0), LayerMask(1, 1), LayerMask(1, 2), LayerMask(1, 3)}},
    {{LayerMask(2, 0), LayerMask(2, 1), LayerMask(2, 2), LayerMask(2, 3)}}};

struct Shifted {
  uint64_t own;    // stays in the brick
  uint64_t carry;  // arrives in the neighbouring brick
};

// In-brick codes of coordinates 0 1 2 3 along an axis are 0 1 8 9 times
// 2^axis, so a step from 1 to 2 is 7 codes, the others 1.
Shifted ShiftUp(uint64_t mask, int axis) {
  const uint64_t* layer = kAxisMasks[axis].layer;
  return {(mask & (layer[0] | layer[2])) << (1 << axis) | (mask & layer[1])
                                                              << (7 << axis),
          (mask & layer[3]) >> (9 << axis)};
}
Shifted ShiftDown(uint64_t mask, int axis) {
  const uint64_t* layer = kAxisMasks[axis].layer;
  return {(mask & (layer[1] | layer[3])) >> (1 << axis) |
              (mask & layer[2]) >> (7 << axis),
          (mask & layer[0]) << (9 << axis)};
}

// Key of the neighbouring brick, or false when it lies outside the root cube.
bool NeighborKey(uint64_t key, int axis, int step, int extent, uint64_t* out) {
  Eigen::Vector3i brick = DecodeMorton(key);
  brick[axis] += step;
  if (brick[axis] < 0 || brick[axis] >= extent) {
    return false;
  }
  *out = EncodeMorton(brick);
  return true;
}

std::vector<Brick> MergeBricks(std::vector<Brick> bricks) {
  std::sort(bricks.begin(), bricks.end(), [](const Brick& a, const Brick& b) {
    return a.key < b.key;
  });
  size_t size = 0;
  for (const Brick& brick : bricks) {
    if (size > 0 && bricks[size - 1].key == brick.key) {
      bricks[size - 1].mask |= brick.mask;
    } else {
      bricks[size++] = brick;
    }
  }
  bricks.resize(size);
  return bricks;
}

// Adds to `out` what one step along `axis` from `bricks` reaches.
void DilateAlong(const std::vector<Brick>& bricks,
                 int axis,
                 int extent,
                 std::vector<Brick>* out) {
  for (const Brick& brick : bricks) {
    const Shifted up = ShiftUp(brick.mask, axis);
    const Shifted down = ShiftDown(brick.mask, axis);
    out->push_back({brick.key, brick.mask | up.own | down.own, 0});
    uint64_t key;
    if (up.carry != 0 && NeighborKey(brick.key, axis, +1, extent, &key)) {
      out->push_back({key, up.carry, 0});
    }
    if (down.carry != 0 && NeighborKey(brick.key, axis, -1, extent, &key)) {
      out->push_back({key, down.carry, 0});
    }
  }
}

// Levels below 2 have less than one brick: what lies outside the cube but in
// the brick is cut off.
void ClipToCube(int level, std::vector<Brick>* bricks) {
  if (level >= 2) {
    return;
  }
  const uint64_t inside = level == 0 ? 1 : 0xff;
  for (Brick& brick : *bricks) {
    brick.mask &= inside;
  }
}

}  // namespace

VoxelGrid Dilate(const VoxelGrid& grid, int steps, const Context& context) {
  const int extent = std::max(1, grid.Resolution() / 4);
  std::vector<Brick> bricks = grid.Bricks();
  for (int step = 0; step < steps; ++step) {
    context.ThrowIfCancelled();
    if (step % 2 == 0) {
      for (int axis = 0; axis < 3; ++axis) {
        std::vector<Brick> next;
        next.reserve(bricks.size() * 2);
        DilateAlong(bricks, axis, extent, &next);
        bricks = MergeBricks(std::move(next));
      }
    } else {
      std::vector<Brick> next;
      next.reserve(bricks.size() * 4);
      for (int axis = 0; axis < 3; ++axis) {
        DilateAlong(bricks, axis, extent, &next);
      }
      bricks = MergeBricks(std::move(next));
    }
    ClipToCube(grid.Level(), &bricks);
  }
  return VoxelGrid::FromBricks(grid.Level(), std::move(bricks));
}

VoxelGrid Children(const VoxelGrid& grid) {
  std::vector<Brick> bricks;
  bricks.reserve(grid.Bricks().size() * 4);
  for (const Brick& parent : grid.Bricks()) {
    for (int octant = 0; octant < 8; ++octant) {
      uint64_t mask = 0;
      for (int bit = 0; bit < 8; ++bit) {
        if ((parent.mask >> (octant * 8 + bit)) & 1) {
          mask |= uint64_t{0xff} << (8 * bit);
        }
      }
      if (mask != 0) {
        bricks.push_back({parent.key << 3 | uint64_t(octant), mask, 0});
      }
    }
  }
  return VoxelGrid::FromBricks(grid.Level() + 1, std::move(bricks));
}

VoxelGrid Subset(const VoxelGrid& grid, std::span<const uint8_t> keep) {
  std::vector<Brick> bricks;
  for (const Brick& brick : grid.Bricks()) {
    uint64_t kept = 0;
    VoxelGrid::Index index = brick.first;
    for (uint64_t mask = brick.mask; mask != 0; mask &= mask - 1, ++index) {
      if (keep[index] != 0) {
        kept |= mask & -mask;
      }
    }
    if (kept != 0) {
      bricks.push_back({brick.key, kept, 0});
    }
  }
  return VoxelGrid::FromBricks(grid.Level(), std::move(bricks));
}

VoxelGrid Union(const VoxelGrid& a, const VoxelGrid& b) {
  if (a.Level() != b.Level()) {
    throw InvariantError("the union of grids of different levels");
  }
  std::vector<Brick> bricks = a.Bricks();
  bricks.insert(bricks.end(), b.Bricks().begin(), b.Bricks().end());
  return VoxelGrid::FromBricks(a.Level(), MergeBricks(std::move(bricks)));
}

}  // namespace octacut
