// Which of the swept depths other views confirm. For core/evidence alone.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/evidence/depth_sweep.h"
#include "core/grid/voxel_grid.h"
#include "core/views/view_set.h"

namespace octacut {

// How far two depths may differ and still agree, in hull voxels.
inline constexpr float kDepthAgreement = 1.5f;

// Whether visit(index) is true for a voxel of the hull that the ray to `depth`
// goes through at least `clearance` hull voxels before it, from there towards
// the view until it leaves the root cube. Voxels may be visited more than once.
template <typename Visit>
bool AnyVoxelBefore(const VoxelGrid& hull,
                    const Eigen::Vector3f& origin,
                    const Eigen::Vector3f& ray,
                    float depth,
                    float clearance,
                    const Visit& visit) {
  const float resolution = float(hull.Resolution());
  const float step = 0.5f / (resolution * ray.norm());
  float d = depth - clearance / resolution;
  while (d > 0) {
    const Eigen::Vector3f point = origin + d * ray;
    if ((point.array() < 0).any() || (point.array() >= 1).any()) {
      return false;
    }
    const VoxelGrid::Index index =
        hull.Find(Eigen::Vector3i((point * resolution).cast<int>()));
    if (index != VoxelGrid::kNone && visit(index)) {
      return true;
    }
    d -= step;
  }
  return false;
}

// How many of its view's neighbours confirm each sample's depth: their own at
// that point is within kDepthAgreement. `voxel` is the side of a hull voxel,
// unit coordinates.
std::vector<std::vector<uint8_t>> CountAgreeing(
    const ViewSet& views,
    const std::vector<SweptDepthMap>& maps,
    const std::vector<std::vector<int>>& neighbors,
    float voxel,
    const Context& context);

// Without the depths that fewer than `min_agreeing` neighbours confirm.
std::vector<SweptDepthMap> KeepAgreeing(
    std::vector<SweptDepthMap> maps,
    const std::vector<std::vector<uint8_t>>& counts,
    int min_agreeing);

// Keeps those of the depths that too few views confirm, but one does,
// - that at least `min_like` of the eight samples around share, to
//   kDepthAgreement: wrong matches are scattered;
// - before which, on their rays, no voxel of the hull is `solid` (one per
//   voxel): what better confirmed depths have found cannot be seen through.
std::vector<SweptDepthMap> KeepPlausible(const ViewSet& views,
                                         const VoxelGrid& hull,
                                         const std::vector<SweptDepthMap>& maps,
                                         const std::vector<bool>& solid,
                                         int min_like,
                                         const Context& context);

}  // namespace octacut
