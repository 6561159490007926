#include "core/pipeline/level_steps.h"

#include <algorithm>
#include <span>
#include <utility>

namespace octacut {

LevelSteps::LevelSteps(const LevelInputs& inputs,
                       int level,
                       LevelSummary* summary)
    : inputs_(inputs), summary_(*summary) {
  summary->level = level;
  summary->resolution = 1 << level;
}

Visibility LevelSteps::EstimateVisibility(
    const VoxelGrid& surface, const std::vector<FaceLabels>& labels) {
  return Timed(&summary_.visibility_seconds, [&] {
    return Visibility::Estimate(inputs_.views,
                                surface,
                                labels,
                                summary_.level,
                                inputs_.options.visibility,
                                inputs_.context);
  });
}

SilhouetteTerms LevelSteps::EstimateSilhouettes(const VoxelGrid& voxels) {
  return OnCrust([&] {
    return EstimateSilhouetteTerms(inputs_.views,
                                   inputs_.evidence.mask_confidence,
                                   voxels,
                                   inputs_.options,
                                   inputs_.context);
  });
}

VoxelTerms LevelSteps::EstimateTerms(const Visibility& visibility,
                                     const Crust& crust,
                                     const SilhouetteTerms& silhouettes) {
  summary_.consistency = {};  // a level that is deepened has those of before
  const AddedVoxels all = OnCrust([&] { return FindAddedVoxels(crust, {}); });
  return AddTerms(visibility, crust, all, silhouettes, {});
}

void LevelSteps::ExtendTerms(const Visibility& visibility,
                             const Crust& crust,
                             VoxelTerms* terms) {
  const AddedVoxels added =
      OnCrust([&] { return FindAddedVoxels(crust, *terms); });
  *terms = AddTerms(
      visibility, crust, added, EstimateSilhouettes(added.voxels), *terms);
}

std::vector<SurfaceShape> LevelSteps::ShapesOf(const Crust& crust,
                                               const AddedVoxels& added) {
  return Timed(&summary_.visibility_seconds, [&] {
    return EstimateSurfaceShape(
        crust.voxels,
        crust.ties,
        crust.prior,
        ReconstructionOptions::kNormalBlur,
        inputs_.context,
        added.AreAll() ? std::span<const uint8_t>() : added.is_added);
  });
}

VoxelTerms LevelSteps::AddTerms(const Visibility& visibility,
                                const Crust& crust,
                                const AddedVoxels& added,
                                const SilhouetteTerms& silhouettes,
                                const VoxelTerms& terms) {
  const ReconstructionOptions& options = inputs_.options;
  const Context& context = inputs_.context;
  // Voxels without shape count as unseen: views of a mirror do not show its
  // surface, and agree by chance. What holds its hull holds them, too.
  const bool is_mirror = inputs_.evidence.is_mirror;
  const std::vector<SurfaceShape> shapes =
      is_mirror ? std::vector<SurfaceShape>(added.voxels.Size(),
                                            {Eigen::Vector3f::Zero(), 0})
                : ShapesOf(crust, added);
  const PhotoConsistency consistency =
      Timed(&summary_.consistency_seconds, [&] {
        return EstimateConsistency(inputs_.views,
                                   added.voxels,
                                   shapes,
                                   visibility,
                                   options.consistency,
                                   context);
      });
  summary_.consistency.Add(consistency.summary);
  return OnCrust([&] {
    return MergeTerms(
        crust.voxels,
        terms,
        added,
        consistency,
        silhouettes,
        is_mirror ? 0.0f : UnseenEvidence(crust.voxels.Level(), options));
  });
}

CutTerms LevelSteps::EnergyOf(const Crust& crust,
                              const VoxelTerms& terms,
                              Decision* decision) const {
  const Context& context = inputs_.context;
  *decision = DecideByPhotographs(
      crust, terms.phi, inputs_.evidence.decision_confidence, context);
  CutTerms energy{DecidedWeights(*decision, terms.phi, inputs_.options),
                  terms.evidence};
  FavorHullBorder(*decision, terms.hull_depth, &energy.weights);
  HoldUndecidedSurface(
      crust, *decision, terms.hull_depth, context, &energy.evidence);
  return energy;
}

OctahedralCut LevelSteps::Cut(const Crust& crust,
                              const CutTerms& terms,
                              OctahedralCutState* state) {
  OctahedralCutProblem problem;
  problem.crust = &crust.voxels;
  problem.weights = terms.weights;
  problem.ties = crust.ties;
  problem.evidence = terms.evidence;
  OctahedralCut cut = Timed(&summary_.cut_seconds, [&] {
    return SolveOctahedralCut(
        problem, inputs_.options.cut, inputs_.context, state);
  });
  summary_.cut_cost = cut.cost;
  summary_.num_cut_voxels = cut.num_cut_voxels;
  summary_.num_graph_nodes = cut.num_nodes;
  summary_.num_crust_voxels = crust.voxels.Size();
  summary_.num_medial_voxels = crust.num_medial_voxels;
  return cut;
}

UncoveredSilhouettes LevelSteps::FindMissed(const Crust& crust,
                                            const OctahedralCut& cut,
                                            int round) {
  UncoveredSilhouettes missed = Timed(&summary_.cover_seconds, [&] {
    return FindUncoveredSilhouettes(
        inputs_.views, crust.voxels, cut.labels, inputs_.context);
  });
  summary_.missed_after = missed.Share();
  if (round == 0) {
    summary_.missed_before = summary_.missed_after;
  }
  summary_.num_cover_rounds = round;
  return missed;
}

void LevelSteps::CoverSilhouettes(const Crust& crust,
                                  const CoverPreference& preference,
                                  CutTerms* terms,
                                  OctahedralCutState* state,
                                  OctahedralCut* cut) {
  if (inputs_.options.evidence.cover_rounds == 0) {
    return;
  }
  const CoverDemand demand = Timed(&summary_.cover_seconds, [&] {
    return DemandCover(inputs_.views,
                       crust,
                       cut->labels,
                       preference,
                       inputs_.context,
                       &terms->evidence);
  });
  summary_.missed_before = std::max(summary_.missed_before, demand.uncovered);
  summary_.missed_after = demand.impossible;
  summary_.num_cover_voxels += demand.num_voxels;
  if (demand.num_voxels > 0) {
    *cut = Cut(crust, *terms, state);
  }
}

bool LevelSteps::GrowCrust(const LabelHierarchy& hierarchy,
                           const OctahedralCut& cut,
                           int round,
                           Crust* crust) {
  return OnCrust([&] {
    const ReconstructionOptions& options = inputs_.options;
    const Context& context = inputs_.context;
    const std::vector<uint8_t> at_border =
        CutAtBorder(*crust, cut.labels, context, &summary_.num_border_voxels);
    summary_.num_grow_rounds = round;
    if (round == options.max_grow_rounds || summary_.num_border_voxels == 0) {
      return false;
    }
    Crust grown = octacut::GrowCrust(
        hierarchy, *crust, at_border, options.crust.crust_dilation, context);
    if (grown.voxels.Size() == crust->voxels.Size()) {
      return false;
    }
    *crust = std::move(grown);
    return true;
  });
}

SolvedLevel LevelSteps::Finish(Decision decision,
                               Crust crust,
                               OctahedralCut cut) {
  summary_.decided_share = DecidedShare(cut.labels, decision);
  return {{std::move(crust.voxels), std::move(cut.labels)},
          std::move(decision.here)};
}

}  // namespace octacut
