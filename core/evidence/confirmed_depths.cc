#include "core/evidence/confirmed_depths.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace octacut {
namespace {

// Calls keep(x, y, depth) for every depth of the maps; where it is false the
// depth is removed.
template <typename KeepOfMap>
std::vector<SweptDepthMap> Keep(const std::vector<SweptDepthMap>& maps,
                                const Context& context,
                                KeepOfMap&& keep_of_map) {
  std::vector<SweptDepthMap> kept = maps;
  ParallelFor(context, maps.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const auto keep = keep_of_map(i);
      for (int y = 0; y < maps[i].height; ++y) {
        for (int x = 0; x < maps[i].width; ++x) {
          float& depth = kept[i].depths[size_t(y) * maps[i].width + x];
          if (depth > 0 && !keep(x, y, depth)) {
            depth = 0;
          }
        }
      }
    }
  });
  return kept;
}

// Of the eight samples around a depth, those that share it.
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

// Whether a point before `depth` on the ray, farther than depths may differ, is
// in a solid voxel.
bool IsBehindSolid(const VoxelGrid& hull,
                   const std::vector<bool>& solid,
                   const Eigen::Vector3f& origin,
                   const Eigen::Vector3f& ray,
                   float depth) {
  const float resolution = float(hull.Resolution());
  const float step = 0.5f / (resolution * ray.norm());
  for (float d = depth - kDepthAgreement / resolution; d > 0; d -= step) {
    const Eigen::Vector3f point = origin + d * ray;
    if ((point.array() < 0).any() || (point.array() >= 1).any()) {
      return false;  // the ray has left the cube towards the view
    }
    const VoxelGrid::Index index =
        hull.Find(Eigen::Vector3i((point * resolution).cast<int>()));
    if (index != VoxelGrid::kNone && solid[index]) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<SweptDepthMap> KeepAgreeing(
    const ViewSet& views,
    const std::vector<SweptDepthMap>& maps,
    const std::vector<std::vector<int>>& neighbors,
    float voxel,
    int min_agreeing,
    const Context& context) {
  return Keep(maps, context, [&](size_t i) {
    const Eigen::Matrix3f rays = views[i].projection.linear.inverse();
    return [&, i, rays](int x, int y, float depth) {
      const Eigen::Vector3f point =
          views[i].projection.center + depth * (rays * maps[i].Pixel(x, y));
      int agreeing = 0;
      for (const int j : neighbors[i]) {
        const std::optional<ProjectedPoint> p =
            views[j].projection.Project(point);
        if (!p) {
          continue;
        }
        const float other = maps[j].DepthAt(p->u, p->v);
        agreeing +=
            other > 0 && std::abs(other - p->depth) <= kDepthAgreement * voxel;
      }
      return agreeing >= min_agreeing;
    };
  });
}

std::vector<SweptDepthMap> KeepPlausible(const ViewSet& views,
                                         const VoxelGrid& hull,
                                         const std::vector<SweptDepthMap>& maps,
                                         const std::vector<bool>& solid,
                                         int min_like,
                                         const Context& context) {
  const float tolerance = kDepthAgreement / float(hull.Resolution());
  return Keep(maps, context, [&](size_t i) {
    const ViewProjection& projection = views[i].projection;
    const Eigen::Matrix3f rays = projection.linear.inverse();
    return [&, i, rays](int x, int y, float depth) {
      return CountLike(maps[i], x, y, depth, tolerance) >= min_like &&
             !IsBehindSolid(hull,
                            solid,
                            projection.center,
                            rays * maps[i].Pixel(x, y),
                            depth);
    };
  });
}

}  // namespace octacut
