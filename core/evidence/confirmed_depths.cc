#include "core/evidence/confirmed_depths.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace octacut {
namespace {

// The number of the eight samples around a depth that share it.
int CountLike(
    const SweptDepthMap& map, int x, int y, float depth, float tolerance) {
  int count = 0;
  for (int b = std::max(0, y - 1); b <= std::min(map.height - 1, y + 1); ++b) {
    for (int a = std::max(0, x - 1); a <= std::min(map.width - 1, x + 1); ++a) {
      const float other = map.depths[size_t(b) * map.width + a];
      count += (a != x || b != y) && other > 0 &&
               std::abs(other - depth) <= tolerance;
    }
  }
  return count;
}

}  // namespace

std::vector<std::vector<uint8_t>> CountAgreeing(
    const ViewSet& views,
    const std::vector<SweptDepthMap>& maps,
    const std::vector<std::vector<int>>& neighbors,
    float voxel,
    const Context& context) {
  std::vector<std::vector<uint8_t>> counts(maps.size());
  ParallelEach(context, maps.size(), 1, [&](size_t i) {
    counts[i].resize(maps[i].depths.size());
    const ViewProjection& projection = views[i].projection;
    ForEachDepth(maps[i],
                 projection,
                 [&](int x, int y, float depth, const Eigen::Vector3f& ray) {
                   const Eigen::Vector3f point =
                       projection.center + depth * ray;
                   uint8_t& count = counts[i][size_t(y) * maps[i].width + x];
                   for (const int j : neighbors[i]) {
                     const std::optional<ProjectedPoint> p =
                         views[j].projection.Project(point);
                     const float other = p ? maps[j].DepthAt(p->u, p->v) : 0;
                     count += other > 0 && std::abs(other - p->depth) <=
                                               kDepthAgreement * voxel;
                   }
                 });
  });
  return counts;
}

std::vector<SweptDepthMap> KeepAgreeing(
    std::vector<SweptDepthMap> maps,
    const std::vector<std::vector<uint8_t>>& counts,
    int min_agreeing) {
  for (size_t i = 0; i < maps.size(); ++i) {
    for (size_t k = 0; k < counts[i].size(); ++k) {
      if (counts[i][k] < min_agreeing) {
        maps[i].depths[k] = 0;
      }
    }
  }
  return maps;
}

std::vector<SweptDepthMap> KeepPlausible(const ViewSet& views,
                                         const VoxelGrid& hull,
                                         const std::vector<SweptDepthMap>& maps,
                                         const std::vector<bool>& solid,
                                         int min_like,
                                         const Context& context) {
  const float tolerance = kDepthAgreement / float(hull.Resolution());
  std::vector<SweptDepthMap> kept = maps;
  ParallelEach(context, maps.size(), 1, [&](size_t i) {
    const ViewProjection& projection = views[i].projection;
    ForEachDepth(maps[i],
                 projection,
                 [&](int x, int y, float depth, const Eigen::Vector3f& ray) {
                   if (CountLike(maps[i], x, y, depth, tolerance) < min_like ||
                       AnyVoxelBefore(hull,
                                      projection.center,
                                      ray,
                                      depth,
                                      kDepthAgreement,
                                      [&](VoxelGrid::Index index) {
                                        return bool(solid[index]);
                                      })) {
                     kept[i].depths[size_t(y) * maps[i].width + x] = 0;
                   }
                 });
  });
  return kept;
}

}  // namespace octacut
