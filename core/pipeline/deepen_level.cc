#include "core/pipeline/deepen_level.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/stopwatch.h"
#include "core/crust/crust.h"
#include "core/evidence/finer_depths.h"
#include "core/pipeline/cut_crust.h"
#include "core/pipeline/undecided_surface.h"
#include "core/pipeline/voxel_terms.h"
#include "core/visibility/visibility.h"

namespace octacut {
namespace {

// Evidence for the present surface where finer depths say nothing, units of the
// weights.
constexpr float kPresentWeight = 0.03f;
// What counts of finer depths beside photo-consistency: free space, so that no
// fold closes again. Their matter would push the surface outward by as much as
// depths are too near beside contours.
constexpr float kFreeSpaceShare = 0.3f;

// The first cut of `crust` is by evidence alone, as that of l0; where there is
// none the present surface, which crust.prior holds, is the best guess.
std::vector<FaceLabels> CutByFinerDepths(
    const ViewSet& views,
    const std::vector<float>& mask_confidence,
    const Crust& crust,
    const std::vector<float>& finer,
    const ReconstructionOptions& options,
    const Context& context,
    LevelSummary* summary) {
  const std::vector<float> weights =
      EdgeWeights(std::vector<float>(crust.voxels.Size(),
                                     float(options.consistency.neutral)),
                  options.energy);
  std::vector<float> held = finer;
  for (size_t i = 0; i < held.size(); ++i) {
    if (held[i] == 0) {
      held[i] = kPresentWeight * (2 * crust.prior[i] - 1);
    }
  }
  Stopwatch stopwatch;
  const SilhouetteTerms silhouettes = EstimateSilhouetteTerms(
      views, mask_confidence, crust.voxels, options, context);
  summary->crust_seconds += stopwatch.Lap();
  OctahedralCutState state;
  OctahedralCut cut =
      CutCrust(crust, weights, held, options, context, summary, &state);
  CoverSilhouettes(views,
                   crust,
                   weights,
                   {{}, silhouettes.hull_depth},
                   options,
                   context,
                   &state,
                   &held,
                   &cut,
                   summary);
  return std::move(cut.labels);
}

}  // namespace

LabeledVoxels DeepenLevel(const ViewSet& views,
                          const InsideEvidence& evidence,
                          const LabelHierarchy& hierarchy,
                          LabeledVoxels solved,
                          const ReconstructionOptions& options,
                          const Context& context,
                          LevelSummary* summary) {
  Stopwatch stopwatch;
  const FinerEvidence finer = FindFinerDepths(
      views, solved, evidence.depth_confidence, options.evidence, context);
  summary->crust_seconds += stopwatch.Lap();
  if (finer.voxels.Empty()) {
    return solved;
  }
  context.Info(
      fmt::format("Level {}: finer depths lead into the surface; its crust "
                  "grows from {} to "
                  "{} voxels.",
                  solved.voxels.Level(),
                  solved.voxels.Size(),
                  finer.voxels.Size()));
  Crust crust = WidenCrust(hierarchy, solved, finer.voxels, context);
  const std::vector<FaceLabels> deepened =
      CutByFinerDepths(views,
                       evidence.mask_confidence,
                       crust,
                       finer.values,
                       options,
                       context,
                       summary);
  stopwatch.Lap();
  AdoptCut(deepened, context, &crust);
  summary->crust_seconds += stopwatch.Lap();
  const Visibility visibility = Visibility::Estimate(views,
                                                     crust.voxels,
                                                     deepened,
                                                     crust.voxels.Level(),
                                                     options.visibility,
                                                     context);
  summary->visibility_seconds += stopwatch.Lap();
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
  std::vector<float> held = terms.evidence;
  HoldUndecidedSurface(crust, decision, terms.hull_depth, context, &held);
  for (size_t i = 0; i < held.size(); ++i) {
    held[i] += kFreeSpaceShare * std::min(finer.values[i], 0.0f);
  }
  OctahedralCutState state;
  OctahedralCut cut =
      CutCrust(crust, weights, held, options, context, summary, &state);
  CoverSilhouettes(views,
                   crust,
                   weights,
                   {{}, terms.hull_depth},
                   options,
                   context,
                   &state,
                   &held,
                   &cut,
                   summary);
  summary->decided_share = DecidedShare(cut.labels, decision);
  return {std::move(crust.voxels), std::move(cut.labels)};
}

}  // namespace octacut
