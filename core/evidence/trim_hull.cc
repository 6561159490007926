#include "core/evidence/trim_hull.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/evidence/mask_confidence.h"
#include "core/grid/morphology.h"
#include "core/grid/voxel_walk.h"

namespace octacut {
namespace {

constexpr size_t kBrickGrain = 64;

bool IsBackgroundOfReliable(const ViewSet& views,
                            const std::vector<float>& mask_confidence,
                            const Eigen::Vector3f& center,
                            float half_edge) {
  for (size_t i = 0; i < views.size(); ++i) {
    if (mask_confidence[i] > kReliableMask &&
        views[i].silhouette.IsBackgroundCube(
            views[i].projection, center, half_edge)) {
      return true;
    }
  }
  return false;
}

}  // namespace

VoxelGrid TrimHull(const ViewSet& views,
                   const VoxelGrid& hull,
                   const Context& context,
                   InsideEvidence* evidence) {
  std::vector<uint8_t> is_kept(hull.Size(), 1);
  const float half_edge = 0.5f / float(hull.Resolution());
  const VoxelWalk walk(hull, context);
  ParallelFor(
      context, walk.NumBricks(), kBrickGrain, [&](size_t begin, size_t end) {
        walk.ForEachWithNeighbors(
            begin, end, [&](const VoxelSlot& slot, const auto& neighbors) {
              const MortonCode code =
                  VoxelGrid::CodeOf(hull.Bricks()[slot.brick], int(slot.bit));
              is_kept[slot.index] =
                  std::count(neighbors.begin(),
                             neighbors.end(),
                             VoxelGrid::kNone) == 0 ||
                  !IsBackgroundOfReliable(
                      views,
                      evidence->mask_confidence,
                      VoxelCenter(DecodeMorton(code), hull.Level()),
                      half_edge);
            });
      });
  size_t num_kept = 0;
  for (size_t i = 0; i < is_kept.size(); ++i) {
    if (is_kept[i]) {
      evidence->values[num_kept++] = evidence->values[i];
    }
  }
  evidence->values.resize(num_kept);
  return Subset(hull, is_kept);
}

}  // namespace octacut
