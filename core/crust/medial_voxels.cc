#include "core/crust/medial_voxels.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/grid/neighbors.h"

namespace octacut {
namespace {

constexpr size_t kBrickGrain = 256;
constexpr int kMaxDepth = 12;
constexpr FaceTies kAllOutside = 0x3f;
constexpr FaceTies kAllInside = 0x3f << 6;

// Depth of each voxel below the prior surface, signed: +k is k voxels into
// the inside, -k into the outside; interfaces of the crust count as deep as
// their neighbours allow (distance is measured within the crust).
std::vector<int8_t> SignedDepth(const VoxelGrid& voxels,
                                const std::vector<float>& prior,
                                const Context& context) {
  std::vector<int8_t> depth(voxels.Size(), 0);
  const auto sign = [&](VoxelGrid::Index i) {
    return prior[i] > 0.5f ? 1 : -1;
  };
  std::vector<int8_t> next(depth.size());
  for (int step = 1; step <= kMaxDepth; ++step) {
    context.ThrowIfCancelled();
    std::vector<uint8_t> changed(NumChunks(voxels.Bricks().size(), kBrickGrain),
                                 0);
    next = depth;
    ParallelChunks(
        context,
        voxels.Bricks().size(),
        kBrickGrain,
        [&](size_t chunk, size_t begin, size_t end) {
          ForEachWithNeighbors(
              voxels,
              begin,
              end,
              [&](VoxelGrid::Index index,
                  MortonCode,
                  const NeighborIndices& neighbors) {
                if (depth[index] != 0) {
                  return;
                }
                for (const VoxelGrid::Index n : neighbors) {
                  const bool reached =
                      n != VoxelGrid::kNone &&
                      (step == 1 ? sign(n) != sign(index)
                                 : sign(n) == sign(index) && depth[n] != 0);
                  if (reached) {
                    next[index] = int8_t(step * sign(index));
                    changed[chunk] = 1;
                    return;
                  }
                }
              });
        });
    depth.swap(next);
    if (std::find(changed.begin(), changed.end(), 1) == changed.end()) {
      break;
    }
  }
  return depth;
}

// Spreads `flags` by one 6-neighbour step within each sign of the depth.
void Spread(const VoxelGrid& voxels,
            const std::vector<int8_t>& depth,
            const Context& context,
            std::vector<uint8_t>* flags) {
  const std::vector<uint8_t> before = *flags;
  ParallelFor(context,
              voxels.Bricks().size(),
              kBrickGrain,
              [&](size_t begin, size_t end) {
                ForEachWithNeighbors(
                    voxels,
                    begin,
                    end,
                    [&](VoxelGrid::Index index,
                        MortonCode,
                        const NeighborIndices& neighbors) {
                      for (const VoxelGrid::Index n : neighbors) {
                        if (n != VoxelGrid::kNone && before[n] &&
                            (depth[n] > 0) == (depth[index] > 0)) {
                          (*flags)[index] = 1;
                        }
                      }
                    });
              });
}

// Voxels from which an interface of their own kind can be reached in as many
// steps as the crust is deep: there the interface is the seed.
std::vector<uint8_t> NearOwnInterface(const VoxelGrid& voxels,
                                      const std::vector<int8_t>& depth,
                                      const std::vector<FaceTies>& ties,
                                      const Context& context) {
  std::vector<uint8_t> near(voxels.Size());
  for (size_t i = 0; i < near.size(); ++i) {
    near[i] = (ties[i] & (depth[i] > 0 ? kAllInside : kAllOutside)) != 0;
  }
  constexpr int kReach = 4;
  for (int step = 0; step < kReach; ++step) {
    Spread(voxels, depth, context, &near);
  }
  return near;
}

}  // namespace

size_t TieMedialVoxels(const VoxelGrid& voxels,
                       const std::vector<float>& prior,
                       const Context& context,
                       std::vector<FaceTies>* ties) {
  const std::vector<int8_t> depth = SignedDepth(voxels, prior, context);
  const std::vector<uint8_t> near =
      NearOwnInterface(voxels, depth, *ties, context);
  std::vector<int8_t> medial(voxels.Size(), 0);
  ForEachWithNeighbors(voxels,
                       0,
                       voxels.Bricks().size(),
                       [&](VoxelGrid::Index index,
                           MortonCode,
                           const NeighborIndices& neighbors) {
                         const int own = std::abs(depth[index]);
                         if (own < 2 || near[index]) {
                           return;
                         }
                         for (const VoxelGrid::Index n : neighbors) {
                           if (n != VoxelGrid::kNone &&
                               (depth[n] > 0) == (depth[index] > 0) &&
                               std::abs(depth[n]) > own) {
                             return;
                           }
                         }
                         medial[index] = depth[index] > 0 ? 1 : -1;
                       });
  size_t count = 0;
  ForEachWithNeighbors(
      voxels,
      0,
      voxels.Bricks().size(),
      [&](VoxelGrid::Index index,
          MortonCode,
          const NeighborIndices& neighbors) {
        if (medial[index] == 0) {
          return;
        }
        // A face shared with a voxel that is tied the other way stays free.
        const FaceTies other = medial[index] > 0 ? kAllOutside : kAllInside;
        if ((*ties)[index] & other) {
          return;
        }
        for (int face = 0; face < kNumFaces; ++face) {
          const VoxelGrid::Index n = neighbors[face];
          if (n != VoxelGrid::kNone && medial[n] == -medial[index]) {
            return;
          }
        }
        (*ties)[index] |= medial[index] > 0 ? kAllInside : kAllOutside;
        ++count;
      });
  return count;
}

}  // namespace octacut
