#include "core/evidence/confidence_in_space.h"

#include <cmath>
#include <optional>
#include <vector>

#include "core/base/parallel.h"
#include "core/grid/voxel_walk.h"

namespace octacut {
namespace {

// A depth within so many hull voxels of a voxel counts for it.
constexpr float kNear = 6;
// So many depths with the confidence of the scene are added to each
// neighbourhood.
constexpr float kPriorNear = 100;
constexpr int kBrickSteps = 2;
constexpr size_t kSpaceGrain = 16;

}  // namespace

VoxelValues ConfidenceInSpace(const ViewSet& views,
                              const VoxelGrid& hull,
                              const ReliableDepths& depths,
                              const Context& context) {
  const float reach = kNear / float(hull.Resolution());
  const size_t num_bricks = hull.Bricks().size();
  std::vector<float> sums(num_bricks);
  std::vector<float> counts(num_bricks);
  ParallelEach(context, num_bricks, kSpaceGrain, [&](size_t b) {
    hull.ForEachInBricks(b, b + 1, [&](VoxelGrid::Index, MortonCode code) {
      const Eigen::Vector3f center =
          VoxelCenter(DecodeMorton(code), hull.Level());
      for (size_t i = 0; i < views.size(); ++i) {
        const std::optional<ProjectedPoint> p =
            views[i].projection.Project(center);
        const float depth = p ? depths.maps[i].DepthAt(p->u, p->v) : 0;
        if (depth > 0 && std::abs(depth - p->depth) < reach) {
          sums[b] += depths.maps[i].ValueAt(depths.confidence[i], p->u, p->v);
          counts[b] += 1;
        }
      }
    });
  });
  const VoxelWalk walk(hull, context);
  for (int step = 0; step < kBrickSteps; ++step) {
    sums = walk.SumOverBrickNeighbors(sums);
    counts = walk.SumOverBrickNeighbors(counts);
  }
  VoxelValues result{hull, std::vector<float>(hull.Size())};
  for (size_t b = 0; b < num_bricks; ++b) {
    hull.ForEachInBricks(b, b + 1, [&](VoxelGrid::Index index, MortonCode) {
      result.values[index] = (sums[b] + kPriorNear * depths.scene_confidence) /
                             (counts[b] + kPriorNear);
    });
  }
  return result;
}

}  // namespace octacut
