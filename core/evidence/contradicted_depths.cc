#include "core/evidence/contradicted_depths.h"

#include <algorithm>
#include <array>
#include <opencv2/core.hpp>
#include <span>
#include <utility>

#include "core/base/parallel.h"
#include "core/evidence/confirmed_depths.h"
#include "core/grid/morphology.h"

namespace octacut {
namespace {

// Distance before a depth, hull voxels, from which on another surface
// contradicts it: twice what depths may differ by, and a voxel.
constexpr float kClear = 4;
// A surface before a depth contradicts it when at least two views have found
// it, and more than this share of those that have found the depth.
constexpr int kMinViews = 2;
constexpr float kContradictingShare = 0.25f;

// For each voxel of the hull, the number of views with a surface in it
// (`within`), and in it or in one of the 26 voxels around (`nearby`; from the
// centres of samples only, as the thresholds for the whole scene were
// measured).
struct SurfaceCounts {
  std::vector<uint16_t> within;
  std::vector<uint16_t> nearby;
};

// A sample is about as wide as a voxel, so the centres of its quarters leave no
// gaps in a surface.
constexpr std::array<float, 1> kCenter = {0};
constexpr std::array<float, 2> kQuarters = {-0.25f, 0.25f};

// The voxels in which a view has found a surface, by points of its samples at
// these offsets in x and y.
VoxelGrid FoundSurface(const ViewProjection& projection,
                       const SweptDepthMap& map,
                       std::span<const float> offsets,
                       int level) {
  const float resolution = float(1 << level);
  const Eigen::Matrix3f rays = projection.RaysOfPixels();
  std::vector<MortonCode> codes;
  ForEachDepth(map, projection, [&](int x, int y, float depth, const auto&) {
    for (const float v : offsets) {
      for (const float u : offsets) {
        const Eigen::Vector3f ray =
            rays * (map.Pixel(x, y) + Eigen::Vector3f(u, v, 0) / map.scale);
        const Eigen::Vector3f point =
            (projection.center + depth * ray) * resolution;
        if ((point.array() >= 0).all() && (point.array() < resolution).all()) {
          codes.push_back(EncodeMorton(Eigen::Vector3i(point.cast<int>())));
        }
      }
    }
  });
  return VoxelGrid::FromCodes(level, std::move(codes));
}

void AddOne(const VoxelGrid& surface,
            const VoxelGrid& hull,
            std::vector<uint16_t>* counts) {
  surface.ForEach([&](VoxelGrid::Index, MortonCode code) {
    const VoxelGrid::Index index = hull.Find(code);
    if (index != VoxelGrid::kNone) {
      ++(*counts)[index];
    }
  });
}

SurfaceCounts CountSurfaces(const ViewSet& views,
                            const VoxelGrid& hull,
                            const std::vector<SweptDepthMap>& maps,
                            const Context& context) {
  std::vector<VoxelGrid> surfaces(maps.size());
  std::vector<VoxelGrid> dilated(maps.size());
  ParallelFor(context, maps.size(), 1, [&](size_t begin, size_t end) {
    const Context alone(1);
    for (size_t i = begin; i < end; ++i) {
      const ViewProjection& projection = views[i].projection;
      surfaces[i] = FoundSurface(projection, maps[i], kQuarters, hull.Level());
      dilated[i] = Dilate(
          FoundSurface(projection, maps[i], kCenter, hull.Level()), 1, alone);
    }
  });
  SurfaceCounts counts{std::vector<uint16_t>(hull.Size()),
                       std::vector<uint16_t>(hull.Size())};
  for (size_t i = 0; i < maps.size(); ++i) {
    AddOne(surfaces[i], hull, &counts.within);
    AddOne(dilated[i], hull, &counts.nearby);
  }
  return counts;
}

int CountAt(const VoxelGrid& hull,
            const std::vector<uint16_t>& counts,
            const Eigen::Vector3f& point) {
  const VoxelGrid::Index index = hull.FindAt(point);
  return index == VoxelGrid::kNone ? 0 : counts[index];
}

// The most views that have found a surface within, and near, one voxel on the
// way to a depth.
struct MostViews {
  int within = 0;
  int nearby = 0;
};

MostViews MostBefore(const VoxelGrid& hull,
                     const SurfaceCounts& counts,
                     const Eigen::Vector3f& origin,
                     const Eigen::Vector3f& ray,
                     float depth) {
  MostViews most;
  AnyVoxelBefore(hull, origin, ray, depth, kClear, [&](VoxelGrid::Index index) {
    most.within = std::max(most.within, int(counts.within[index]));
    most.nearby = std::max(most.nearby, int(counts.nearby[index]));
    return false;
  });
  return most;
}

bool IsContradicted(int before, int own) {
  return before >= kMinViews &&
         float(before) > kContradictingShare * float(own);
}

JudgedMap JudgeMap(const ViewProjection& projection,
                   const VoxelGrid& hull,
                   const SurfaceCounts& counts,
                   const SweptDepthMap& map) {
  const auto none = [&] {
    return cv::Mat1b(cv::Mat1b::zeros(map.height, map.width));
  };
  JudgedMap judged{none(), none(), none(), none()};
  ForEachDepth(map,
               projection,
               [&](int x, int y, float depth, const Eigen::Vector3f& ray) {
                 const int own = CountAt(
                     hull, counts.nearby, projection.center + depth * ray);
                 const MostViews before =
                     MostBefore(hull, counts, projection.center, ray, depth);
                 judged.is_depth(y, x) = 1;
                 judged.is_contradicted(y, x) =
                     IsContradicted(before.within, own);
                 judged.is_nearly_contradicted(y, x) =
                     IsContradicted(before.nearby, own);
                 judged.is_outvoted(y, x) =
                     before.nearby >= kMinViews && before.nearby > own;
               });
  return judged;
}

}  // namespace

std::vector<JudgedMap> JudgeDepths(const ViewSet& views,
                                   const VoxelGrid& hull,
                                   const std::vector<SweptDepthMap>& maps,
                                   const Context& context) {
  const SurfaceCounts counts = CountSurfaces(views, hull, maps, context);
  std::vector<JudgedMap> judged(maps.size());
  ParallelEach(context, maps.size(), 1, [&](size_t i) {
    judged[i] = JudgeMap(views[i].projection, hull, counts, maps[i]);
  });
  return judged;
}

std::vector<SweptDepthMap> WithoutOutvoted(
    std::vector<SweptDepthMap> maps, const std::vector<JudgedMap>& judged) {
  for (size_t i = 0; i < maps.size(); ++i) {
    for (size_t k = 0; k < maps[i].depths.size(); ++k) {
      if (judged[i].is_outvoted(int(k)) != 0) {
        maps[i].depths[k] = 0;
      }
    }
  }
  return maps;
}

}  // namespace octacut
