#include "core/evidence/depth_confidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

#include "core/base/parallel.h"
#include "core/base/ramp.h"
#include "core/evidence/confirmed_depths.h"
#include "core/grid/morphology.h"
#include "core/grid/voxel_walk.h"

namespace octacut {
namespace {

// Distance before a depth, hull voxels, from which on another surface
// contradicts it: twice what depths may differ by, and a voxel.
constexpr float kClear = 4;
// A surface before a depth contradicts it when at least two views have found
// it, and more than this share of those that have found the depth.
constexpr int kMinViews = 2;
constexpr float kContradictingShare = 0.25f;
// Half the side of the part of a view, hull voxels, whose depths are relied
// upon together.
constexpr float kRegionRadius = 8;
// Shares of nearly contradicted depths there: up to the first they are relied
// upon, from the second on, where three fifths of all are wrong, not at all.
constexpr float kSureShareOfRegion = 1.0f / 6;
constexpr float kDoubtfulShareOfRegion = 0.4f;
// By this both limits are multiplied for contradicted depths: fewer depths are
// contradicted than nearly contradicted.
constexpr float kContradictedByNearly = 0.7f;
// Shares of nearly contradicted depths of the whole scene: up to the first they
// are relied upon; from the second on they must be dense to be relied upon. Few
// views have few depths, but those do not contradict each other.
constexpr float kSureShare = 1.0f / 6;
constexpr float kManyShare = 0.25f;
// Shares of the object's samples, over all views, that have a depth: up to the
// first, which chance alone reaches on metal and porcelain, such depths are not
// relied upon, from the second on they are. A hollow of a textured object has
// few depths, and right ones, so regions are not asked.
constexpr float kSparse = 0.3f;
constexpr float kDense = 0.5f;
// The same where photographs show what the object mirrors: metal with relief
// has up to 0.36.
constexpr float kDenseForMirrors = 0.7f;
// Where views have all their neighbours, up to this share the object has next
// to nothing to match, and few contradictions do not speak for its depths:
// plain and mirroring cups, boxes and lumps have 0.05 to 0.14, while textured
// objects whose views are too far apart to be matched have as few.
constexpr float kBlank = 0.15f;
// Contradicted depths by found ones: the fewer surfaces are found, the fewer
// wrong depths have one in front of them. Objects whose depths are mostly right
// have at most 0.6, also with few views; plain and mirroring ones 1.2 and more.
constexpr float kSureRatio = 0.6f;
constexpr float kDoubtfulRatio = 1.2f;
// The shares of the views with all their neighbours up to which views count as
// far apart, and from which on they do not.
constexpr float kFarApart = 0.5f;
constexpr float kNearby = 0.75f;
// Depths without contradiction that every part is given: few tell nothing.
constexpr float kPriorDepths = 20;
// Depths this near to a voxel, hull voxels, speak of it; and as many with the
// confidence of the scene are added to those of a neighbourhood.
constexpr float kNear = 6;
constexpr float kPriorNear = 100;
constexpr int kBrickSteps = 2;
constexpr size_t kBrickGrain = 16;

// For each voxel of the hull, how many views have found a surface in it, and
// how many in it or in one of the 26 voxels around it, by the centres of
// samples alone, which the shares of the whole scene were fixed with.
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
  const Eigen::Matrix3f rays = projection.linear.inverse();
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
  if ((point.array() < 0).any() || (point.array() >= 1).any()) {
    return 0;
  }
  const VoxelGrid::Index index = hull.Find(
      Eigen::Vector3i((point * float(hull.Resolution())).cast<int>()));
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

// Sums over squares of an image.
class SquareSums {
 public:
  SquareSums(int width, int height, const std::vector<uint8_t>& values)
      : width_(width),
        height_(height),
        stride_(size_t(width) + 1),
        sums_(stride_ * (size_t(height) + 1)) {
    for (int y = 0; y < height; ++y) {
      uint32_t row = 0;
      for (int x = 0; x < width; ++x) {
        row += values[size_t(y) * width + x];
        sums_[(y + 1) * stride_ + x + 1] = sums_[y * stride_ + x + 1] + row;
      }
    }
  }

  float Around(int x, int y, int radius) const {
    const int x0 = std::max(0, x - radius);
    const int y0 = std::max(0, y - radius);
    const int x1 = std::min(width_, x + radius + 1);
    const int y1 = std::min(height_, y + radius + 1);
    return float(sums_[y1 * stride_ + x1] - sums_[y0 * stride_ + x1] -
                 sums_[y1 * stride_ + x0] + sums_[y0 * stride_ + x0]);
  }

 private:
  int width_;
  int height_;
  size_t stride_;
  std::vector<uint32_t> sums_;
};

// Which samples of a map have a depth, which of those are contradicted by
// surfaces that their ray passes through, and which are outvoted by those that
// it passes within a voxel. Nearly contradicted are also depths whose ray
// passes a surface within a voxel, as rays into a cup pass its rim: right
// depths in hollows are among them, but where few depths are found only they
// show which contradict each other.
struct JudgedMap {
  std::vector<uint8_t> is_depth;
  std::vector<uint8_t> is_contradicted;
  std::vector<uint8_t> is_nearly_contradicted;
  std::vector<uint8_t> is_outvoted;
};

bool IsContradicted(int before, int own) {
  return before >= kMinViews &&
         float(before) > kContradictingShare * float(own);
}

JudgedMap JudgeDepths(const ViewProjection& projection,
                      const VoxelGrid& hull,
                      const SurfaceCounts& counts,
                      const SweptDepthMap& map) {
  const size_t size = map.depths.size();
  JudgedMap judged{std::vector<uint8_t>(size),
                   std::vector<uint8_t>(size),
                   std::vector<uint8_t>(size),
                   std::vector<uint8_t>(size)};
  ForEachDepth(map,
               projection,
               [&](int x, int y, float depth, const Eigen::Vector3f& ray) {
                 const size_t k = size_t(y) * map.width + x;
                 const int own = CountAt(
                     hull, counts.nearby, projection.center + depth * ray);
                 const MostViews before =
                     MostBefore(hull, counts, projection.center, ray, depth);
                 judged.is_depth[k] = 1;
                 judged.is_contradicted[k] = IsContradicted(before.within, own);
                 judged.is_nearly_contradicted[k] =
                     IsContradicted(before.nearby, own);
                 judged.is_outvoted[k] =
                     before.nearby >= kMinViews && before.nearby > own;
               });
  return judged;
}

size_t CountObjectSamples(const Silhouette& silhouette,
                          const SweptDepthMap& map) {
  size_t count = 0;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const Eigen::Vector3f pixel = map.Pixel(x, y);
      count += silhouette.SignedDistance(pixel.x(), pixel.y()) > 0 ? 1 : 0;
    }
  }
  return count;
}

// How far the depths of the whole scene can be relied upon.
float ConfidenceOfScene(double contradicted_share,
                        double found_share,
                        double surrounded_share,
                        float shown) {
  const float dense = Ramp(float(found_share), kSparse, kDense);
  const float consistent =
      Ramp(float(contradicted_share), kManyShare, kSureShare) *
      Ramp(float(contradicted_share / std::max(found_share, 1e-6)),
           kDoubtfulRatio,
           kSureRatio);
  const float can_be_few =
      std::max(Ramp(float(found_share), kBlank, kSparse),
               Ramp(float(surrounded_share), kNearby, kFarApart));
  return std::max(Ramp(float(found_share), kDense, kDenseForMirrors),
                  shown * std::max(dense, consistent * can_be_few));
}

// How far the depths around each sample can be relied upon, 0 .. 1. The lower
// the confidence of the scene, the more nearly contradicted depths count
// instead of contradicted ones: on plain objects, whole regions have wrong
// depths that agree with each other.
std::vector<float> ConfidenceOfRegions(const ViewProjection& projection,
                                       const VoxelGrid& hull,
                                       const SweptDepthMap& map,
                                       const JudgedMap& judged,
                                       float scene_confidence) {
  const int width = map.width;
  const int height = map.height;
  const SquareSums depths(width, height, judged.is_depth);
  const SquareSums contradicted(width, height, judged.is_contradicted);
  const SquareSums nearly(width, height, judged.is_nearly_contradicted);
  const float samples_per_voxel =
      map.scale * projection.CenterFootprint(1.0f / float(hull.Resolution()));
  const int radius = int(std::lround(kRegionRadius * samples_per_voxel));
  std::vector<float> confidence(map.depths.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float num_depths = depths.Around(x, y, radius) + kPriorDepths;
      const auto of_share = [&](float share) {
        return Ramp(share, kDoubtfulShareOfRegion, kSureShareOfRegion);
      };
      confidence[size_t(y) * width + x] =
          std::lerp(of_share(nearly.Around(x, y, radius) / num_depths),
                    of_share(contradicted.Around(x, y, radius) /
                             (kContradictedByNearly * num_depths)),
                    scene_confidence);
    }
  }
  return confidence;
}

double ShareOf(const std::vector<size_t>& some,
               const std::vector<size_t>& all) {
  const auto sum = [](const std::vector<size_t>& numbers) {
    return std::accumulate(numbers.begin(), numbers.end(), size_t{0});
  };
  return double(sum(some)) / double(std::max<size_t>(sum(all), 1));
}

}  // namespace

ReliableDepths EstimateDepthConfidence(const ViewSet& views,
                                       const VoxelGrid& hull,
                                       const std::vector<SweptDepthMap>& maps,
                                       double surrounded_share,
                                       float shown,
                                       const Context& context) {
  const SurfaceCounts counts = CountSurfaces(views, hull, maps, context);
  ReliableDepths result{maps, std::vector<std::vector<float>>(maps.size())};
  std::vector<JudgedMap> judged(maps.size());
  std::vector<size_t> num_depths(maps.size());
  std::vector<size_t> num_contradicted(maps.size());
  std::vector<size_t> num_samples(maps.size());
  ParallelFor(context, maps.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      judged[i] = JudgeDepths(views[i].projection, hull, counts, maps[i]);
      num_samples[i] = CountObjectSamples(views[i].silhouette, maps[i]);
      for (size_t k = 0; k < judged[i].is_depth.size(); ++k) {
        num_depths[i] += judged[i].is_depth[k];
        num_contradicted[i] += judged[i].is_nearly_contradicted[k];
        if (judged[i].is_outvoted[k]) {
          result.maps[i].depths[k] = 0;
        }
      }
    }
  });
  result.contradicted_share = ShareOf(num_contradicted, num_depths);
  result.found_share = ShareOf(num_depths, num_samples);
  result.scene_confidence = ConfidenceOfScene(
      result.contradicted_share, result.found_share, surrounded_share, shown);
  ParallelFor(context, maps.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      result.confidence[i] = ConfidenceOfRegions(views[i].projection,
                                                 hull,
                                                 maps[i],
                                                 judged[i],
                                                 result.scene_confidence);
      for (float& value : result.confidence[i]) {
        value *= result.scene_confidence;
      }
    }
  });
  return result;
}

VoxelValues ConfidenceInSpace(const ViewSet& views,
                              const VoxelGrid& hull,
                              const ReliableDepths& depths,
                              const Context& context) {
  const float reach = kNear / float(hull.Resolution());
  const size_t num_bricks = hull.Bricks().size();
  std::vector<float> sums(num_bricks);
  std::vector<float> counts(num_bricks);
  ParallelFor(context, num_bricks, kBrickGrain, [&](size_t begin, size_t end) {
    for (size_t b = begin; b < end; ++b) {
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
    }
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
