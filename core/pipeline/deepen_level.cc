#include "core/pipeline/deepen_level.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/stopwatch.h"
#include "core/crust/crust.h"
#include "core/cut/octahedral_cut.h"
#include "core/evidence/finer_depths.h"
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

std::vector<FaceLabels> Cut(const Crust& crust,
                            const std::vector<float>& weights,
                            const std::vector<float>& evidence,
                            const ReconstructionOptions& options,
                            const Context& context,
                            LevelSummary* summary) {
  Stopwatch stopwatch;
  OctahedralCutProblem problem;
  problem.crust = &crust.voxels;
  problem.weights = weights;
  problem.ties = crust.ties;
  problem.evidence = evidence;
  OctahedralCut cut = SolveOctahedralCut(problem, options.cut, context);
  summary->cut_seconds += stopwatch.Lap();
  summary->cut_cost = cut.cost;
  summary->num_cut_voxels = cut.num_cut_voxels;
  summary->num_graph_nodes = cut.num_nodes;
  summary->num_crust_voxels = crust.voxels.Size();
  summary->num_medial_voxels = crust.num_medial_voxels;
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
      views, solved, evidence.depth_trust, options.evidence, context);
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
  // By evidence alone, as l0.
  std::vector<float> weights =
      EdgeWeights(std::vector<float>(crust.voxels.Size(),
                                     float(options.consistency.neutral)),
                  options.energy);
  std::vector<float> held = finer.values;
  for (size_t i = 0; i < held.size(); ++i) {
    if (held[i] == 0) {
      held[i] = kPresentWeight * (2 * crust.prior[i] - 1);
    }
  }
  solved.labels = Cut(crust, weights, held, options, context, summary);
  stopwatch.Lap();
  AdoptCut(solved.labels, context, &crust);
  summary->crust_seconds += stopwatch.Lap();
  const Visibility visibility = Visibility::Estimate(views,
                                                     crust.voxels,
                                                     solved.labels,
                                                     crust.voxels.Level(),
                                                     options.visibility,
                                                     context);
  summary->visibility_seconds += stopwatch.Lap();
  VoxelTerms terms;
  ExtendTerms(views,
              evidence.mask_trust,
              visibility,
              crust,
              options,
              context,
              &terms,
              summary);
  const Decision decision =
      DecideByPhotographs(crust, terms.phi, evidence.depth_trust, context);
  weights = EdgeWeights(terms.phi, options.energy);
  FlattenUndecidedWeights(decision, options, &weights);
  held = terms.evidence;
  HoldUndecidedSurface(crust, decision, terms.hull_depth, context, &held);
  for (size_t i = 0; i < held.size(); ++i) {
    held[i] += kFreeSpaceShare * std::min(finer.values[i], 0.0f);
  }
  solved.labels = Cut(crust, weights, held, options, context, summary);
  solved.voxels = std::move(crust.voxels);
  return solved;
}

}  // namespace octacut
