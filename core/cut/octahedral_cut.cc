#include "core/cut/octahedral_cut.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/cut/cut_problem.h"
#include "core/cut/fixed_point.h"
#include "core/cut/implicit_cut.h"

namespace octacut {

OctahedralCut SolveOctahedralCut(const OctahedralCutProblem& problem,
                                 const OctahedralCutOptions& options,
                                 const Context& context) {
  options.Check();
  CheckCutValues(problem, context);
  if (options.observer) {
    options.observer(problem);
  }
  const VoxelWalk walk(*problem.crust);
  std::vector<FaceTies> ties = MergeFaceTies(problem, walk, context);
  const SearchPlan plan = PlanSearch(ties);
  OctahedralCut cut = SolveImplicitly(problem, walk, ties, plan, context);
  // A cut that costs what flows is a minimum cut, and the flow a maximum.
  const int64_t cost = LabellingCost(problem, walk, ties, cut.labels, context);
  if (cost != cut.cost_fixed_point) {
    throw InvariantError(fmt::format(
        "cut: cost {} differs from flow {}", cost, cut.cost_fixed_point));
  }
  cut.cost = FromFixed(cost);
  cut.num_cut_voxels =
      size_t(std::count_if(cut.labels.begin(), cut.labels.end(), IsCut));
  return cut;
}

size_t EstimateOctahedralCutBytes(size_t num_voxels, bool with_evidence) {
  return EstimateImplicitCutBytes(num_voxels, with_evidence);
}

}  // namespace octacut
