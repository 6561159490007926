#include "core/pipeline/level_step.h"

#include <algorithm>
#include <bit>

#include "core/base/stopwatch.h"
#include "core/crust/medial_voxels.h"
#include "core/cut/fixed_point.h"
#include "core/evidence/uncovered_silhouettes.h"
#include "core/pipeline/cut_crust.h"
#include "core/pipeline/undecided_surface.h"
#include "core/pipeline/voxel_terms.h"

namespace octacut {
namespace {

// Share of the silhouettes' samples up to which no round asks them back: that
// much is not a part of the object, and CoverSilhouettes has it at once.
constexpr double kToleratedMiss = 1e-3;

Visibility EstimateVisibility(const ViewSet& views,
                              const VoxelGrid& surface,
                              const std::vector<FaceLabels>& labels,
                              int level,
                              const ReconstructionOptions& options,
                              const Context& context,
                              LevelSummary* summary) {
  Stopwatch stopwatch;
  Visibility visibility = Visibility::Estimate(
      views, surface, labels, level, options.visibility, context);
  summary->visibility_seconds += stopwatch.Lap();
  return visibility;
}

// The cut of l0 by evidence alone. What all silhouettes show must not be cut
// off: where it is, wrong depths have outvoted matter, so `evidence` gets the
// word of those silhouettes until nearly all are covered. The others get matter
// where it is likeliest on their rays.
OctahedralCut CutByEvidence(const ViewSet& views,
                            const Crust& crust,
                            const std::vector<float>& hull_depth,
                            const ReconstructionOptions& options,
                            const Context& context,
                            std::vector<float>* evidence,
                            LevelSummary* summary) {
  const std::vector<float> weights =
      EdgeWeights(std::vector<float>(crust.voxels.Size(),
                                     float(options.consistency.neutral)),
                  options.energy);
  OctahedralCutState state;
  double weight = options.evidence.cover_weight;
  for (int round = 0;; ++round, weight *= 2) {
    OctahedralCut cut =
        CutCrust(crust, weights, *evidence, options, context, summary, &state);
    Stopwatch stopwatch;
    const UncoveredSilhouettes missed =
        FindUncoveredSilhouettes(views, crust.voxels, cut.labels, context);
    summary->cover_seconds += stopwatch.Lap();
    summary->missed_after = double(missed.num_uncovered) /
                            double(std::max<size_t>(missed.num_samples, 1));
    if (round == 0) {
      summary->missed_before = summary->missed_after;
    }
    summary->num_cover_rounds = round;
    if (round == options.evidence.cover_rounds ||
        summary->missed_after <= kToleratedMiss) {
      const std::vector<float> asked = *evidence;
      CoverSilhouettes(views,
                       crust,
                       weights,
                       {asked, hull_depth},
                       options,
                       context,
                       &state,
                       evidence,
                       &cut,
                       summary);
      return cut;
    }
    for (size_t i = 0; i < evidence->size(); ++i) {
      (*evidence)[i] = std::min(
          (*evidence)[i] + float(weight) * missed.shares[i], kMaxEvidence);
    }
  }
}

void BeginLevel(int level, LevelSummary* summary) {
  summary->level = level;
  summary->resolution = 1 << level;
}

}  // namespace

LabeledVoxels SolveInitialLevel(const ViewSet& views,
                                const VoxelGrid& hull,
                                const InsideEvidence& evidence,
                                const ReconstructionOptions& options,
                                const Context& context,
                                LevelSummary* summary) {
  BeginLevel(hull.Level(), summary);
  Stopwatch stopwatch;
  Crust crust = InitialCrust(hull, context);
  summary->crust_seconds += stopwatch.Lap();
  SilhouetteTerms silhouettes = EstimateSilhouetteTerms(
      views, evidence.mask_confidence, hull, options, context);
  std::vector<float> prior = std::move(silhouettes.evidence);
  for (size_t i = 0; i < prior.size(); ++i) {
    prior[i] += evidence.values[i];
  }
  OctahedralCut cut = CutByEvidence(
      views, crust, silhouettes.hull_depth, options, context, &prior, summary);

  stopwatch.Lap();
  for (size_t i = 0; i < crust.prior.size(); ++i) {
    crust.prior[i] = float(std::popcount(cut.labels[i])) / kNumFaces;
  }
  crust.num_medial_voxels =
      TieMedialVoxels(crust.voxels, crust.prior, context, &crust.ties);
  summary->crust_seconds += stopwatch.Lap();
  const Visibility visibility = EstimateVisibility(
      views, crust.voxels, cut.labels, hull.Level(), options, context, summary);
  VoxelTerms terms;
  ExtendTerms(views,
              evidence.mask_confidence,
              visibility,
              crust,
              options,
              context,
              &terms,
              summary);
  const Decision decision =
      DecideByPhotographs(crust, terms.phi, evidence.depth_confidence, context);
  std::vector<float> weights = EdgeWeights(terms.phi, options.energy);
  FlattenUndecidedWeights(decision, options, &weights);
  OctahedralCutState state;
  cut = CutCrust(crust, weights, prior, options, context, summary, &state);
  CoverSilhouettes(views,
                   crust,
                   weights,
                   {{}, terms.hull_depth},
                   options,
                   context,
                   &state,
                   &prior,
                   &cut,
                   summary);
  summary->decided_share = DecidedShare(cut.labels, decision);
  return {std::move(crust.voxels), std::move(cut.labels)};
}

LabeledVoxels SolveFinerLevel(const ViewSet& views,
                              const InsideEvidence& evidence,
                              const LabelHierarchy& hierarchy,
                              const ReconstructionOptions& options,
                              const Context& context,
                              LevelSummary* summary) {
  BeginLevel(hierarchy.Finest().voxels.Level() + 1, summary);
  Stopwatch stopwatch;
  Crust crust = RefineCrust(hierarchy, options.crust, context);
  summary->crust_seconds += stopwatch.Lap();
  const LabeledVoxels& coarse = hierarchy.Finest();
  const Visibility visibility = EstimateVisibility(views,
                                                   coarse.voxels,
                                                   coarse.labels,
                                                   crust.voxels.Level(),
                                                   options,
                                                   context,
                                                   summary);
  VoxelTerms terms;
  OctahedralCutState state;
  for (int round = 0;; ++round) {
    ExtendTerms(views,
                evidence.mask_confidence,
                visibility,
                crust,
                options,
                context,
                &terms,
                summary);
    const Decision decision = DecideByPhotographs(
        crust, terms.phi, evidence.depth_confidence, context);
    std::vector<float> weights = EdgeWeights(terms.phi, options.energy);
    FlattenUndecidedWeights(decision, options, &weights);
    FavorHullBorder(decision, terms.hull_depth, &weights);
    std::vector<float> held = terms.evidence;
    HoldUndecidedSurface(crust, decision, terms.hull_depth, context, &held);
    summary->crust_seconds += stopwatch.Lap();
    OctahedralCutState* kept = options.max_grow_rounds > 0 ? &state : nullptr;
    OctahedralCut cut =
        CutCrust(crust, weights, held, options, context, summary, kept);
    stopwatch.Lap();
    const std::vector<uint8_t> at_border =
        CutAtBorder(crust, cut.labels, context, &summary->num_border_voxels);
    summary->num_grow_rounds = round;
    if (round < options.max_grow_rounds && summary->num_border_voxels > 0) {
      Crust grown = GrowCrust(
          hierarchy, crust, at_border, options.crust.crust_dilation, context);
      if (grown.voxels.Size() > crust.voxels.Size()) {
        crust = std::move(grown);
        summary->crust_seconds += stopwatch.Lap();
        continue;
      }
    }
    summary->crust_seconds += stopwatch.Lap();
    CoverSilhouettes(views,
                     crust,
                     weights,
                     {{}, terms.hull_depth},
                     options,
                     context,
                     kept,
                     &held,
                     &cut,
                     summary);
    summary->decided_share = DecidedShare(cut.labels, decision);
    return {std::move(crust.voxels), std::move(cut.labels)};
  }
}

}  // namespace octacut
