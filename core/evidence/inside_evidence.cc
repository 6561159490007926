#include "core/evidence/inside_evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/check_option.h"
#include "core/evidence/confirmed_depths.h"
#include "core/evidence/depth_confidence.h"
#include "core/evidence/depth_evidence.h"
#include "core/evidence/mask_confidence.h"
#include "core/grid/parallel_voxels.h"

namespace octacut {
namespace {

// In hull voxels: how far before a surface space is surely free; the zone
// behind it that is surely matter.
constexpr float kFreeBefore = 1.5f;
constexpr float kMatterFrom = 1.0f;
constexpr float kMatterTo = 3.5f;
// Views for matter that count at most, and half of those for free space, so
// that many views of one side do not drown the others.
constexpr float kMaxVotes = 4;
// What the first view that sees through a voxel lacks of a vote: on its own
// its depth may be wrong and would drill a tunnel.
constexpr float kSingleView = 0.5f;
// Evidence, in words of views for matter, beyond which a voxel is solid.
constexpr double kSolidViews = 0.8;

// Depths that are wrong lie behind the surface, nearly all of them: what a
// doubtful depth says of matter is right or does no harm, what it says of free
// space and of surfaces counts as far as it can be relied upon.
float EvidenceAt(const ViewSet& views,
                 const ReliableDepths& depths,
                 const Eigen::Vector3f& point,
                 float voxel,
                 const InsideEvidenceOptions& options) {
  float matter = 0;
  float free_space = 0;
  float near_surface = 0;
  for (size_t i = 0; i < views.size(); ++i) {
    const std::optional<ProjectedPoint> p = views[i].projection.Project(point);
    if (!p) {
      continue;
    }
    const SweptDepthMap& map = depths.maps[i];
    const float depth = map.DepthAt(p->u, p->v);
    if (depth == 0) {
      continue;
    }
    const float confidence = map.ValueAt(depths.confidence[i], p->u, p->v);
    const float behind = (p->depth - depth) / voxel;
    if (behind < -kFreeBefore) {
      free_space += confidence;
    } else if (behind > kMatterFrom && behind < kMatterTo) {
      matter += 1;
    } else if (behind <= kMatterFrom) {
      near_surface = std::max(near_surface, confidence);
    }
  }
  // Beside a surface that some view has found, photo-consistency decides.
  return (1 - near_surface) * float(options.ballooning) +
         float(options.matter_weight) * std::min(matter, kMaxVotes) -
         float(options.free_space_weight) *
             std::clamp(free_space - kSingleView, 0.0f, 2 * kMaxVotes);
}

}  // namespace

size_t CountDepths(const std::vector<SweptDepthMap>& maps) {
  size_t count = 0;
  for (const SweptDepthMap& map : maps) {
    count += map.depths.size() -
             size_t(std::count(map.depths.begin(), map.depths.end(), 0.0f));
  }
  return count;
}

std::vector<float> EvidenceOf(const ViewSet& views,
                              const VoxelGrid& hull,
                              const ReliableDepths& depths,
                              const InsideEvidenceOptions& options,
                              const Context& context) {
  std::vector<float> values(hull.Size());
  ParallelForVoxels(
      context, hull, [&](VoxelGrid::Index index, MortonCode code) {
        values[index] =
            EvidenceAt(views,
                       depths,
                       VoxelCenter(DecodeMorton(code), hull.Level()),
                       1.0f / float(hull.Resolution()),
                       options);
      });
  return values;
}

std::vector<SweptDepthMap> FindPlausible(
    const ViewSet& views,
    const VoxelGrid& voxels,
    const std::vector<SweptDepthMap>& paired,
    const std::vector<float>& values,
    const InsideEvidenceOptions& options,
    const Context& context) {
  const float least =
      float(options.ballooning + kSolidViews * options.matter_weight);
  std::vector<bool> solid(values.size());
  std::transform(values.begin(), values.end(), solid.begin(), [&](float value) {
    return value > least;
  });
  return KeepPlausible(
      views, voxels, paired, solid, options.min_like_samples, context);
}

void AddMissing(const std::vector<SweptDepthMap>& others,
                std::vector<SweptDepthMap>* maps) {
  for (size_t i = 0; i < maps->size(); ++i) {
    std::vector<float>& depths = (*maps)[i].depths;
    for (size_t k = 0; k < depths.size(); ++k) {
      depths[k] = depths[k] > 0 ? depths[k] : others[i].depths[k];
    }
  }
}

namespace {

// The depths that are rather right than wrong.
std::vector<SweptDepthMap> KeepReliable(const ReliableDepths& depths) {
  constexpr float kRatherRight = 0.5f;
  std::vector<SweptDepthMap> kept = depths.maps;
  for (size_t i = 0; i < kept.size(); ++i) {
    for (size_t k = 0; k < kept[i].depths.size(); ++k) {
      if (depths.confidence[i][k] < kRatherRight) {
        kept[i].depths[k] = 0;
      }
    }
  }
  return kept;
}

// The number of the views that have fewer than `count` neighbours.
size_t CountLonely(const std::vector<std::vector<int>>& neighbors, int count) {
  return size_t(std::count_if(
      neighbors.begin(), neighbors.end(), [&](const std::vector<int>& of_view) {
        return of_view.size() < size_t(count);
      }));
}

void WarnOfNoDepths(const std::vector<std::vector<int>>& neighbors,
                    const InsideEvidenceOptions& options,
                    const Context& context) {
  context.Warn(
      fmt::format("No depth is confirmed by {} other views, so concavities "
                  "stay filled. {} of {} views have fewer neighbouring views "
                  "at angles of {} to {} degrees.",
                  options.min_agreeing_views,
                  CountLonely(neighbors, options.min_agreeing_views),
                  neighbors.size(),
                  options.sweep.min_angle,
                  options.sweep.max_angle));
}

size_t CountFree(const std::vector<float>& values) {
  return size_t(std::count_if(
      values.begin(), values.end(), [](float value) { return value < 0; }));
}

// From this share of contradicted depths on, half of all depths are wrong.
constexpr double kManyContradictions = 0.3;

void WarnOfContradictions(double share, const Context& context) {
  if (share < kManyContradictions) {
    return;
  }
  context.Warn(fmt::format(
      "The photographs contradict each other: {:.0f} % of the depths found in "
      "them lie behind surfaces that other views have found. There, the "
      "silhouettes determine the surface, and concavities may stay filled. "
      "Usual causes are highlights or a light that moves with the camera; "
      "diffuse light or a matt coating helps.",
      100 * share));
}

}  // namespace

void CheckEvidenceWeight(std::string_view field, double weight) {
  CheckOption(weight >= 0 && weight <= kMaxEvidenceWeight,
              field,
              weight,
              fmt::format("must be in 0 .. {}", kMaxEvidenceWeight));
}

void InsideEvidenceOptions::Check() const {
  sweep.Check();
  CheckOption(
      min_agreeing_views >= 1 && min_agreeing_views <= sweep.num_neighbors,
      "min_agreeing_views",
      min_agreeing_views,
      fmt::format("must be in 1 .. num_neighbors = {}", sweep.num_neighbors));
  CheckOption(min_like_samples >= 0 && min_like_samples <= 9,
              "min_like_samples",
              min_like_samples,
              "must be in 0 .. 9");
  CheckEvidenceWeight("ballooning", ballooning);
  CheckEvidenceWeight("matter_weight", matter_weight);
  CheckEvidenceWeight("free_space_weight", free_space_weight);
  CheckOption(
      cover_weight > 0 && cover_weight <= kMaxEvidenceWeight,
      "cover_weight",
      cover_weight,
      fmt::format("must be positive and at most {}", kMaxEvidenceWeight));
  CheckOption(cover_rounds >= 0 && cover_rounds <= 8,
              "cover_rounds",
              cover_rounds,
              "must be in 0 .. 8");
}

InsideEvidence EstimateInsideEvidence(const ViewSet& views,
                                      const VoxelGrid& hull,
                                      const InsideEvidenceOptions& options,
                                      float shown,
                                      const Context& context) {
  options.Check();
  const float voxel = 1.0f / float(hull.Resolution());
  std::vector<std::vector<int>> neighbors;
  const std::vector<SweptDepthMap> swept =
      SweepDepths(views, hull, options.sweep, context, &neighbors);
  const std::vector<std::vector<uint8_t>> counts =
      CountAgreeing(views, swept, neighbors, voxel, context);
  const std::vector<SweptDepthMap> agreeing =
      KeepAgreeing(swept, counts, options.min_agreeing_views);
  const double surrounded_share =
      1 - double(CountLonely(neighbors, options.sweep.num_neighbors)) /
              double(neighbors.size());
  ReliableDepths depths = EstimateDepthConfidence(
      views, hull, agreeing, surrounded_share, shown, context);
  InsideEvidence evidence;
  evidence.mask_confidence =
      EstimateMaskConfidence(views, KeepReliable(depths), context);
  evidence.values = EvidenceOf(views, hull, depths, options, context);
  evidence.summary.num_depths = CountDepths(swept);
  evidence.summary.num_agreeing = CountDepths(agreeing);
  evidence.summary.contradicted_share = depths.contradicted_share;
  evidence.summary.found_share = depths.found_share;
  if (evidence.summary.num_agreeing == 0) {
    WarnOfNoDepths(neighbors, options, context);
  }
  WarnOfContradictions(depths.contradicted_share, context);
  const size_t num_kept = CountDepths(depths.maps);
  if (options.min_agreeing_views > 1 && options.min_like_samples <= 8) {
    AddMissing(FindPlausible(views,
                             hull,
                             KeepAgreeing(swept, counts, 1),
                             evidence.values,
                             options,
                             context),
               &depths.maps);
    evidence.values = EvidenceOf(views, hull, depths, options, context);
  }
  evidence.depth_confidence = ConfidenceInSpace(views, hull, depths, context);
  evidence.decision_confidence = evidence.depth_confidence;
  evidence.summary.num_plausible = CountDepths(depths.maps) - num_kept;
  evidence.summary.num_free_voxels = CountFree(evidence.values);
  evidence.depths = std::move(depths);
  return evidence;
}

void ReviseEvidence(const ViewSet& views,
                    const VoxelGrid& hull,
                    const ReliableDepths& surface,
                    const InsideEvidenceOptions& options,
                    const Context& context,
                    InsideEvidence* evidence) {
  ReliableDepths& depths = evidence->depths;
  // The confidence of the region still counts; that of the scene is replaced by
  // the judgement of the surface itself.
  const float scene = std::max(depths.scene_confidence, 1e-6f);
  for (size_t i = 0; i < depths.confidence.size(); ++i) {
    for (size_t k = 0; k < depths.confidence[i].size(); ++k) {
      if (surface.maps[i].depths[k] > 0) {
        const float of_region = std::min(depths.confidence[i][k] / scene, 1.0f);
        depths.confidence[i][k] = surface.confidence[i][k] * of_region;
      }
    }
  }
  evidence->values = EvidenceOf(views, hull, depths, options, context);
  evidence->summary.num_free_voxels = CountFree(evidence->values);
  const VoxelGrid& voxels = evidence->depth_confidence.voxels;
  VoxelValues revised = ConfidenceInSpace(views, voxels, depths, context);
  const VoxelValues of_surface =
      ConfidenceInSpace(views, voxels, surface, context);
  for (size_t i = 0; i < revised.values.size(); ++i) {
    revised.values[i] *= of_surface.values[i];
  }
  evidence->decision_confidence = std::move(revised);
}

}  // namespace octacut
