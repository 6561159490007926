#include "core/cut/octahedral_cut.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cut/cut_problem.h"
#include "core/cut/fixed_point.h"
#include "core/cut/implicit_cut.h"

namespace octacut {

namespace {

// The finest in which the greatest weight fits narrow flows, from 14 bits on.
CutScale LeanScale(std::span<const float> weights) {
  CutScale scale{kCutFractionBits - kLeanFractionBits};
  float greatest = 0;
  for (const float weight : weights) {
    greatest = std::max(greatest, weight);
  }
  while (!weights.empty() && scale.Weight(greatest) > kMaxLeanWeight) {
    ++scale.shift;
  }
  return scale;
}

}  // namespace

OctahedralCutState::OctahedralCutState() = default;
OctahedralCutState::~OctahedralCutState() = default;
OctahedralCutState::OctahedralCutState(OctahedralCutState&&) noexcept = default;
OctahedralCutState& OctahedralCutState::operator=(
    OctahedralCutState&&) noexcept = default;

OctahedralCut SolveOctahedralCut(const OctahedralCutProblem& problem,
                                 const OctahedralCutOptions& options,
                                 const Context& context,
                                 OctahedralCutState* state) {
  CheckCutValues(problem, context);
  if (options.observer) {
    options.observer(problem);
  }
  const VoxelWalk walk(*problem.crust, context);
  std::vector<FaceTies> ties = MergeFaceTies(problem, walk, context);
  SearchPlan plan = PlanSearch(ties, context);
  if (options.lean) {
    plan.scale = LeanScale(problem.weights);
  }
  std::unique_ptr<ImplicitCutState> kept;
  if (state != nullptr) {
    kept = state->state_ != nullptr ? std::move(state->state_)
                                    : std::make_unique<ImplicitCutState>();
  }
  OctahedralCut cut =
      SolveImplicitly(problem, walk, ties, plan, context, kept.get());
  // A cut that costs what flows is a minimum cut, and the flow a maximum.
  const int64_t cost =
      LabellingCost(problem, walk, ties, cut.labels, plan.scale, context);
  if (cost != cut.cost_fixed_point) {
    throw InvariantError(fmt::format(
        "cut: cost {} differs from flow {}", cost, cut.cost_fixed_point));
  }
  if (options.lean) {
    cut.cost_fixed_point =
        LabellingCost(problem, walk, ties, cut.labels, {}, context);
  }
  if (state != nullptr) {
    state->state_ = std::move(kept);
  }
  cut.cost = FromFixed(cut.cost_fixed_point);
  cut.num_cut_voxels = size_t(ParallelSum(
      context,
      cut.labels.size(),
      kCutVoxelGrain,
      [&](size_t begin, size_t end) {
        const auto labels = std::span(cut.labels).subspan(begin, end - begin);
        return std::count_if(labels.begin(), labels.end(), IsCut);
      }));
  return cut;
}

size_t EstimateOctahedralCutBytes(size_t num_voxels,
                                  bool with_evidence,
                                  bool lean) {
  return EstimateImplicitCutBytes(num_voxels, with_evidence, lean);
}

}  // namespace octacut
