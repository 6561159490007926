#include "core/pipeline/cut_crust.h"

#include <algorithm>

#include "core/base/stopwatch.h"

namespace octacut {

OctahedralCut CutCrust(const Crust& crust,
                       const std::vector<float>& weights,
                       const std::vector<float>& evidence,
                       const ReconstructionOptions& options,
                       const Context& context,
                       LevelSummary* summary,
                       OctahedralCutState* state) {
  Stopwatch stopwatch;
  OctahedralCutProblem problem;
  problem.crust = &crust.voxels;
  problem.weights = weights;
  problem.ties = crust.ties;
  problem.evidence = evidence;
  OctahedralCut cut = SolveOctahedralCut(problem, options.cut, context, state);
  summary->cut_seconds += stopwatch.Lap();
  summary->cut_cost = cut.cost;
  summary->num_cut_voxels = cut.num_cut_voxels;
  summary->num_graph_nodes = cut.num_nodes;
  summary->num_crust_voxels = crust.voxels.Size();
  summary->num_medial_voxels = crust.num_medial_voxels;
  return cut;
}

void CoverSilhouettes(const ViewSet& views,
                      const Crust& crust,
                      const std::vector<float>& weights,
                      const CoverPreference& preference,
                      const ReconstructionOptions& options,
                      const Context& context,
                      OctahedralCutState* state,
                      std::vector<float>* evidence,
                      OctahedralCut* cut,
                      LevelSummary* summary) {
  if (options.evidence.cover_rounds == 0) {
    return;
  }
  Stopwatch stopwatch;
  const CoverDemand demand =
      DemandCover(views, crust, cut->labels, preference, context, evidence);
  summary->cover_seconds += stopwatch.Lap();
  summary->missed_before = std::max(summary->missed_before, demand.uncovered);
  summary->missed_after = demand.impossible;
  summary->num_cover_voxels += demand.num_voxels;
  if (demand.num_voxels > 0) {
    *cut =
        CutCrust(crust, weights, *evidence, options, context, summary, state);
  }
}

}  // namespace octacut
