#include "core/evidence/inside_evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/check_option.h"
#include "core/evidence/confidence_in_space.h"
#include "core/evidence/confirmed_depths.h"
#include "core/evidence/depth_confidence.h"
#include "core/evidence/depth_evidence.h"
#include "core/evidence/mask_confidence.h"

namespace octacut {
namespace {

// The depths that are rather right than wrong.
std::vector<SweptDepthMap> KeepReliable(const ReliableDepths& depths) {
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
      fmt::format("No depth that a view found is confirmed by {} other views, "
                  "so concavities may stay filled. {} of {} views have fewer "
                  "than {} neighbours whose viewing directions differ from "
                  "theirs by {} to {} degrees.",
                  options.min_agreeing_views,
                  CountLonely(neighbors, options.min_agreeing_views),
                  neighbors.size(),
                  options.min_agreeing_views,
                  options.sweep.min_angle,
                  options.sweep.max_angle));
}

size_t CountFree(const std::vector<float>& values) {
  return size_t(std::count_if(
      values.begin(), values.end(), [](float value) { return value < 0; }));
}

// Below this share of the object's samples with a depth, fainter contrast is
// asked; its depths count if they are so many times as many.
constexpr double kFewFound = 0.3;
constexpr double kFaintContrast = 0.5;
constexpr double kManyMore = 1.4;

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

// A sweep of all views, with the views that confirm its depths.
struct JudgedSweep {
  std::vector<std::vector<int>> neighbors;
  std::vector<SweptDepthMap> swept;
  std::vector<std::vector<uint8_t>> counts;  // as CountAgreeing has them
  size_t num_agreeing = 0;
  ReliableDepths depths;  // of those that enough views confirm
};

JudgedSweep SweepAndJudge(const ViewSet& views,
                          const VoxelGrid& hull,
                          const InsideEvidenceOptions& options,
                          float shown,
                          const Context& context) {
  const float voxel = 1.0f / float(hull.Resolution());
  JudgedSweep sweep;
  sweep.swept =
      SweepDepths(views, hull, options.sweep, context, &sweep.neighbors);
  sweep.counts =
      CountAgreeing(views, sweep.swept, sweep.neighbors, voxel, context);
  const std::vector<SweptDepthMap> agreeing =
      KeepAgreeing(sweep.swept, sweep.counts, options.min_agreeing_views);
  sweep.num_agreeing = CountDepths(agreeing);
  const double surrounded_share =
      1 - double(CountLonely(sweep.neighbors, options.sweep.num_neighbors)) /
              double(sweep.neighbors.size());
  sweep.depths = EstimateDepthConfidence(
      views, hull, agreeing, surrounded_share, shown, context);
  return sweep;
}

// Where few depths are found on what is no mirror, windows of half the contrast
// are tried: a faint texture has many more depths then, a plain surface hardly
// any (docs/experiments/faint_texture.md).
JudgedSweep SweepForDepths(const ViewSet& views,
                           const VoxelGrid& hull,
                           InsideEvidenceOptions options,
                           float shown,
                           const Context& context) {
  JudgedSweep sweep = SweepAndJudge(views, hull, options, shown, context);
  if (shown > 0 && sweep.depths.found_share < kFewFound) {
    options.sweep.plain_deviation *= kFaintContrast;
    JudgedSweep faint = SweepAndJudge(views, hull, options, shown, context);
    if (faint.depths.found_share > kManyMore * sweep.depths.found_share) {
      return faint;
    }
  }
  return sweep;
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
  JudgedSweep sweep = SweepForDepths(views, hull, options, shown, context);
  ReliableDepths& depths = sweep.depths;
  InsideEvidence evidence;
  evidence.mask_confidence =
      EstimateMaskConfidence(views, KeepReliable(depths), context);
  evidence.summary.num_depths = CountDepths(sweep.swept);
  evidence.summary.num_agreeing = sweep.num_agreeing;
  evidence.summary.contradicted_share = depths.contradicted_share;
  evidence.summary.found_share = depths.found_share;
  if (evidence.summary.num_agreeing == 0) {
    WarnOfNoDepths(sweep.neighbors, options, context);
  }
  WarnOfContradictions(depths.contradicted_share, context);
  const size_t num_kept = CountDepths(depths.maps);
  evidence.values =
      EvidenceWithPlausible(views,
                            hull,
                            KeepAgreeing(sweep.swept, sweep.counts, 1),
                            options,
                            context,
                            &depths);
  evidence.depth_confidence = ConfidenceInSpace(views, hull, depths, context);
  evidence.decision_confidence = evidence.depth_confidence;
  evidence.is_mirror = depths.is_mirror;
  evidence.summary.num_plausible = CountDepths(depths.maps) - num_kept;
  evidence.summary.num_free_voxels = CountFree(evidence.values);
  evidence.depths = std::move(depths);
  return evidence;
}

void ReviseEvidence(const ViewSet& views,
                    const VoxelGrid& hull,
                    const SurfaceVerdict& surface,
                    const InsideEvidenceOptions& options,
                    const Context& context,
                    InsideEvidence* evidence) {
  ReliableDepths& depths = evidence->depths;
  // The confidence of the region still counts; that of the scene is replaced by
  // the judgement of the surface itself.
  const float scene = std::max(depths.scene_confidence, 1e-6f);
  for (size_t i = 0; i < depths.confidence.size(); ++i) {
    for (size_t k = 0; k < depths.confidence[i].size(); ++k) {
      if (surface.depths.maps[i].depths[k] > 0) {
        const float of_region = std::min(depths.confidence[i][k] / scene, 1.0f);
        depths.confidence[i][k] = surface.depths.confidence[i][k] * of_region;
      }
    }
  }
  evidence->values = EvidenceOf(views, hull, depths, options, context);
  AddMatterInPits(views, hull, surface, options, context, &evidence->values);
  evidence->summary.num_free_voxels = CountFree(evidence->values);
  const VoxelGrid& voxels = evidence->depth_confidence.voxels;
  VoxelValues revised = ConfidenceInSpace(views, voxels, depths, context);
  const VoxelValues of_surface =
      ConfidenceInSpace(views, voxels, surface.depths, context);
  for (size_t i = 0; i < revised.values.size(); ++i) {
    revised.values[i] *= of_surface.values[i];
  }
  evidence->decision_confidence = std::move(revised);
}

}  // namespace octacut
