#include "core/evidence/depth_confidence.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"
#include "core/base/ramp.h"
#include "core/evidence/contradicted_depths.h"

namespace octacut {
namespace {

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
constexpr float kSureShareOfScene = 1.0f / 6;
constexpr float kManyShareOfScene = 0.25f;
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

// How many pixels are 1 in the square around each one.
cv::Mat1f CountAround(const cv::Mat1b& ones, int radius) {
  cv::Mat1f counts;
  cv::boxFilter(ones,
                counts,
                CV_32F,
                {2 * radius + 1, 2 * radius + 1},
                {-1, -1},
                false,
                cv::BORDER_CONSTANT);
  return counts;
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
      Ramp(float(contradicted_share), kManyShareOfScene, kSureShareOfScene) *
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
  const float samples_per_voxel =
      map.scale * projection.CenterFootprint(1.0f / float(hull.Resolution()));
  const int radius = int(std::lround(kRegionRadius * samples_per_voxel));
  const cv::Mat1f depths = CountAround(judged.is_depth, radius);
  const cv::Mat1f contradicted = CountAround(judged.is_contradicted, radius);
  const cv::Mat1f nearly = CountAround(judged.is_nearly_contradicted, radius);
  std::vector<float> confidence(map.depths.size());
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const float num_depths = depths(y, x) + kPriorDepths;
      const auto of_share = [&](float share) {
        return Ramp(share, kDoubtfulShareOfRegion, kSureShareOfRegion);
      };
      confidence[size_t(y) * map.width + x] = std::lerp(
          of_share(nearly(y, x) / num_depths),
          of_share(contradicted(y, x) / (kContradictedByNearly * num_depths)),
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
  const std::vector<JudgedMap> judged = JudgeDepths(views, hull, maps, context);
  ReliableDepths result{WithoutOutvoted(maps, judged),
                        std::vector<std::vector<float>>(maps.size())};
  std::vector<size_t> num_depths(maps.size());
  std::vector<size_t> num_nearly_contradicted(maps.size());
  std::vector<size_t> num_samples(maps.size());
  ParallelEach(context, maps.size(), 1, [&](size_t i) {
    num_samples[i] = CountObjectSamples(views[i].silhouette, maps[i]);
    num_depths[i] = size_t(cv::countNonZero(judged[i].is_depth));
    num_nearly_contradicted[i] =
        size_t(cv::countNonZero(judged[i].is_nearly_contradicted));
  });
  result.contradicted_share = ShareOf(num_nearly_contradicted, num_depths);
  result.found_share = ShareOf(num_depths, num_samples);
  result.scene_confidence = ConfidenceOfScene(
      result.contradicted_share, result.found_share, surrounded_share, shown);
  result.is_mirror = shown == 0 && result.scene_confidence == 0;
  ParallelEach(context, maps.size(), 1, [&](size_t i) {
    result.confidence[i] = ConfidenceOfRegions(
        views[i].projection, hull, maps[i], judged[i], result.scene_confidence);
    for (float& value : result.confidence[i]) {
      value *= result.scene_confidence;
    }
  });
  return result;
}

}  // namespace octacut
