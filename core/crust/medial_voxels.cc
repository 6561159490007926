#include "core/crust/medial_voxels.h"

#include <algorithm>
#include <cstdlib>

#include "core/base/parallel.h"
#include "core/grid/voxel_walk.h"

namespace octacut {
namespace {

constexpr size_t kMedialGrain = 256;
// Deeper voxels are no part of anything thin.
constexpr int kMaxDepth = 12;

// Whether any of a voxel's neighbours is one that `fits`.
template <typename Fits>
bool AnyNeighbor(const VoxelWalk& walk, const VoxelSlot& slot, Fits&& fits) {
  for (int face = 0; face < kNumFaces; ++face) {
    const VoxelGrid::Index n = walk.Neighbor(slot, face);
    if (n != VoxelGrid::kNone && fits(n)) {
      return true;
    }
  }
  return false;
}

// Depth of each voxel below the prior surface, signed: +k is k voxels into
// the inside, -k into the outside; interfaces of the crust count as deep as
// their neighbours allow (distance is measured within the crust). What is
// deeper than kMaxDepth is one deeper.
std::vector<int8_t> SignedDepth(const VoxelWalk& walk,
                                const std::vector<float>& prior,
                                const Context& context) {
  std::vector<int8_t> depth(prior.size(), 0);
  const auto sign = [&](VoxelGrid::Index i) {
    return prior[i] > 0.5f ? 1 : -1;
  };
  std::vector<int8_t> next(depth.size());
  for (int step = 1; step <= kMaxDepth; ++step) {
    context.ThrowIfCancelled();
    std::vector<uint8_t> changed(NumChunks(walk.NumBricks(), kMedialGrain), 0);
    next = depth;
    ParallelChunks(context,
                   walk.NumBricks(),
                   kMedialGrain,
                   [&](size_t chunk, size_t begin, size_t end) {
                     walk.ForEach(begin, end, [&](const VoxelSlot& slot) {
                       const int own = sign(slot.index);
                       if (depth[slot.index] == 0 &&
                           AnyNeighbor(walk, slot, [&](VoxelGrid::Index n) {
                             return step == 1 ? sign(n) != own
                                              : sign(n) == own && depth[n] != 0;
                           })) {
                         next[slot.index] = int8_t(step * own);
                         changed[chunk] = 1;
                       }
                     });
                   });
    depth.swap(next);
    if (std::find(changed.begin(), changed.end(), 1) == changed.end()) {
      break;
    }
  }
  for (size_t i = 0; i < depth.size(); ++i) {
    if (depth[i] == 0) {
      depth[i] = int8_t((kMaxDepth + 1) * sign(VoxelGrid::Index(i)));
    }
  }
  return depth;
}

// Spreads `flags` by one 6-neighbour step within each sign of the depth.
void Spread(const VoxelWalk& walk,
            const std::vector<int8_t>& depth,
            const Context& context,
            std::vector<uint8_t>* flags) {
  const std::vector<uint8_t> before = *flags;
  ParallelFor(
      context, walk.NumBricks(), kMedialGrain, [&](size_t begin, size_t end) {
        walk.ForEach(begin, end, [&](const VoxelSlot& slot) {
          const bool inside = depth[slot.index] > 0;
          if (!before[slot.index] &&
              AnyNeighbor(walk, slot, [&](VoxelGrid::Index n) {
                return before[n] && (depth[n] > 0) == inside;
              })) {
            (*flags)[slot.index] = 1;
          }
        });
      });
}

// Voxels from which an interface of their own kind can be reached in as many
// steps as the crust is deep: there the interface is the seed.
std::vector<uint8_t> NearOwnInterface(const VoxelWalk& walk,
                                      const std::vector<int8_t>& depth,
                                      const std::vector<FaceTies>& ties,
                                      const Context& context) {
  std::vector<uint8_t> near(depth.size());
  for (size_t i = 0; i < near.size(); ++i) {
    near[i] = (ties[i] & (depth[i] > 0 ? kAllInside : kAllOutside)) != 0;
  }
  constexpr int kReach = 4;
  for (int step = 0; step < kReach; ++step) {
    Spread(walk, depth, context, &near);
  }
  return near;
}

// +1 for medial voxels of the inside, -1 for those of the outside, else 0.
std::vector<int8_t> FindMedial(const VoxelWalk& walk,
                               const std::vector<int8_t>& depth,
                               int min_depth,
                               const std::vector<uint8_t>& near) {
  std::vector<int8_t> medial(depth.size(), 0);
  walk.ForEach(0, walk.NumBricks(), [&](const VoxelSlot& slot) {
    const int8_t own = depth[slot.index];
    if (std::abs(own) >= min_depth && std::abs(own) <= kMaxDepth &&
        !near[slot.index] && !AnyNeighbor(walk, slot, [&](VoxelGrid::Index n) {
          return (depth[n] > 0) == (own > 0) &&
                 std::abs(depth[n]) > std::abs(own);
        })) {
      medial[slot.index] = own > 0 ? 1 : -1;
    }
  });
  return medial;
}

}  // namespace

size_t TieMedialVoxels(const VoxelGrid& voxels,
                       const std::vector<float>& prior,
                       int min_depth,
                       const Context& context,
                       std::vector<FaceTies>* ties) {
  const VoxelWalk walk(voxels, context);
  const std::vector<int8_t> depth = SignedDepth(walk, prior, context);
  const std::vector<int8_t> medial = FindMedial(
      walk, depth, min_depth, NearOwnInterface(walk, depth, *ties, context));
  size_t count = 0;
  walk.ForEach(0, walk.NumBricks(), [&](const VoxelSlot& slot) {
    const int8_t own = medial[slot.index];
    // A face shared with a voxel that is tied the other way stays free.
    const FaceTies other = own > 0 ? kAllOutside : kAllInside;
    if (own != 0 && ((*ties)[slot.index] & other) == 0 &&
        !AnyNeighbor(walk, slot, [&](VoxelGrid::Index n) {
          return medial[n] == -own;
        })) {
      (*ties)[slot.index] |= own > 0 ? kAllInside : kAllOutside;
      ++count;
    }
  });
  return count;
}

}  // namespace octacut
