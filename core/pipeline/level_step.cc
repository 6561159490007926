#include "core/pipeline/level_step.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/cut/fixed_point.h"

namespace octacut {
namespace {

// Rounds end when at most this share of the silhouettes' samples is uncovered:
// that much is not a part of the object, and CoverSilhouettes restores it in
// one cut.
constexpr double kToleratedMiss = 1e-3;
// Medial voxels of l0 at least this deep are tied: plain objects lose less of
// their thick parts. What is thinner may be a bridge that the first cut has
// made up (docs/experiments/crusts.md).
constexpr int kSolidDepth = 4;

// The cut of l0 by evidence alone. What all silhouettes show must not be cut
// off: where it is, wrong depths have outvoted matter, so the evidence gets the
// word of those silhouettes until nearly all are covered. The others get matter
// where it is likeliest on their rays.
OctahedralCut CutByEvidence(const LevelInputs& inputs,
                            const Crust& crust,
                            const std::vector<float>& hull_depth,
                            LevelSteps* steps,
                            std::vector<float>* evidence) {
  const ReconstructionOptions& options = inputs.options;
  CutTerms terms{
      std::vector<float>(crust.voxels.Size(), NeutralWeight(options)),
      std::move(*evidence)};
  OctahedralCutState state;
  double weight = InsideEvidenceOptions::kCoverWeight;
  for (int round = 0;; ++round, weight *= 2) {
    OctahedralCut cut = steps->Cut(crust, terms, &state);
    const UncoveredSilhouettes missed = steps->FindMissed(crust, cut, round);
    if (round == options.evidence.cover_rounds ||
        missed.Share() <= kToleratedMiss) {
      const std::vector<float> asked = terms.evidence;
      steps->CoverSilhouettes(crust, {asked, hull_depth}, &terms, &state, &cut);
      *evidence = std::move(terms.evidence);
      return cut;
    }
    for (size_t i = 0; i < terms.evidence.size(); ++i) {
      terms.evidence[i] = std::min(
          terms.evidence[i] + float(weight) * missed.shares[i], kMaxEvidence);
    }
  }
}

}  // namespace

SolvedLevel SolveInitialLevel(const LevelInputs& inputs,
                              const VoxelGrid& hull,
                              LevelSummary* summary) {
  const InsideEvidence& evidence = inputs.evidence;
  const ReconstructionOptions& options = inputs.options;
  const Context& context = inputs.context;
  LevelSteps steps(inputs, hull.Level(), summary);
  Crust crust = steps.OnCrust([&] { return InitialCrust(hull, context); });
  const SilhouetteTerms silhouettes = steps.EstimateSilhouettes(hull);
  std::vector<float> inside = silhouettes.evidence;
  for (size_t i = 0; i < inside.size(); ++i) {
    inside[i] += evidence.values[i];
  }
  if (evidence.is_mirror) {
    HoldHull(silhouettes.hull_depth, &inside);
  }
  const OctahedralCut first =
      CutByEvidence(inputs, crust, silhouettes.hull_depth, &steps, &inside);
  steps.OnCrust([&] { AdoptCut(first.labels, kSolidDepth, context, &crust); });
  const VoxelTerms terms = steps.EstimateTerms(
      steps.EstimateVisibility(crust.voxels, first.labels), crust, silhouettes);
  Decision decision = DecideByPhotographs(
      crust, terms.phi, evidence.decision_confidence, context);
  CutTerms energy{DecidedWeights(decision, terms.phi, options),
                  std::move(inside)};
  OctahedralCutState state;
  OctahedralCut cut = steps.Cut(crust, energy, &state);
  steps.CoverSilhouettes(crust, {{}, terms.hull_depth}, &energy, &state, &cut);
  return steps.Finish(std::move(decision), std::move(crust), std::move(cut));
}

SolvedLevel SolveFinerLevel(const LevelInputs& inputs,
                            const LabelHierarchy& hierarchy,
                            LevelSummary* summary) {
  const ReconstructionOptions& options = inputs.options;
  const LabeledVoxels& coarse = hierarchy.Finest();
  LevelSteps steps(inputs, coarse.voxels.Level() + 1, summary);
  Crust crust = steps.OnCrust(
      [&] { return RefineCrust(hierarchy, options.crust, inputs.context); });
  const Visibility visibility =
      steps.EstimateVisibility(coarse.voxels, coarse.labels);
  VoxelTerms terms;
  OctahedralCutState state;
  OctahedralCutState* kept = options.max_grow_rounds > 0 ? &state : nullptr;
  for (int round = 0;; ++round) {
    steps.ExtendTerms(visibility, crust, &terms);
    Decision decision;
    CutTerms energy = steps.EnergyOf(crust, terms, &decision);
    OctahedralCut cut = steps.Cut(crust, energy, kept);
    if (!steps.GrowCrust(hierarchy, cut, round, &crust)) {
      steps.CoverSilhouettes(
          crust, {{}, terms.hull_depth}, &energy, kept, &cut);
      return steps.Finish(
          std::move(decision), std::move(crust), std::move(cut));
    }
  }
}

SolvedLevel CutByPhotographs(Crust crust,
                             const std::vector<FaceLabels>& surface,
                             const std::vector<float>& evidence,
                             const SilhouetteTerms& silhouettes,
                             LevelSteps* steps) {
  const VoxelTerms terms = steps->EstimateTerms(
      steps->EstimateVisibility(crust.voxels, surface), crust, silhouettes);
  Decision decision;
  CutTerms energy = steps->EnergyOf(crust, terms, &decision);
  for (size_t i = 0; i < evidence.size(); ++i) {
    energy.evidence[i] += evidence[i];
  }
  OctahedralCutState state;
  OctahedralCut cut = steps->Cut(crust, energy, &state);
  steps->CoverSilhouettes(crust, {{}, terms.hull_depth}, &energy, &state, &cut);
  return steps->Finish(std::move(decision), std::move(crust), std::move(cut));
}

size_t EstimateLevelBytes(double area, const ReconstructionOptions& options) {
  // Grid, ties, prior, phi, weights, evidence, normals and depth maps. The
  // state of a cut is there beside them while its crust may grow.
  constexpr size_t kBytesPerVoxel = 48;
  const size_t num_voxels =
      EstimateCrustVoxels(options.target_level, area, options.crust);
  return num_voxels * kBytesPerVoxel +
         EstimateOctahedralCutBytes(num_voxels, true, options.cut.lean);
}

}  // namespace octacut
