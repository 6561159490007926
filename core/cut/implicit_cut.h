// The octahedral cut without a graph: the voxel grid is the graph.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/cut/fixed_point.h"
#include "core/cut/octahedral_cut.h"
#include "core/grid/voxel_walk.h"

namespace octacut {

// Told by the thread that does it when work on regions [begin, end) begins and
// ends: one region alone, or the search after two halves were joined.
using SearchObserver =
    std::function<void(size_t begin, size_t end, bool begins)>;

// How to search; all but the scale changes the time, never the result.
struct SearchPlan {
  // Regions of about so many voxels are searched alone, then joined pairwise.
  uint32_t region_voxels = 1 << 15;
  // Bricks that are flooded by themselves in the end (source_side.h).
  uint32_t flood_bricks = 2048;
  // Any other than the finest makes flows of 16 bits; the greatest weight is
  // then at most kMaxLeanWeight.
  CutScale scale = {};
  SearchObserver observer = nullptr;
};

template <typename Flow>
class FlowState;

// What a cut leaves behind, from which that of a crust that grew out of its own
// can go on.
struct ImplicitCutState {
  ImplicitCutState();
  ~ImplicitCutState();

  std::vector<VoxelGrid::Brick> bricks;  // of the crust
  // One of them, by the scale of the plan; or neither.
  std::unique_ptr<FlowState<int32_t>> flows;
  std::unique_ptr<FlowState<int16_t>> narrow_flows;
};

// The plan that measurements speak for (docs/experiments/cut_engine.md).
SearchPlan PlanSearch(std::span<const FaceTies> merged_ties,
                      const Context& context);

// Solves a problem whose values are checked (cut_problem.h). Its merged ties
// are freed during the search and made again after it. Fills labels,
// cost_fixed_point (the flow) and num_nodes of the result, which depend
// neither on the plan nor on the number of threads. Throws InvariantError
// when a residual arc leaves the source side.
//
// With a state the cut goes on from what is in it, where scale and evidence are
// of the same kind, and leaves there what it ends with; throws InputError when
// the problem's crust lacks a voxel of the state's.
OctahedralCut SolveImplicitly(const OctahedralCutProblem& problem,
                              const VoxelWalk& walk,
                              std::vector<FaceTies>& merged_ties,
                              const SearchPlan& plan,
                              const Context& context,
                              ImplicitCutState* state = nullptr);

// Bytes SolveImplicitly and the proof need at their peak.
size_t EstimateImplicitCutBytes(size_t num_voxels,
                                bool with_evidence,
                                bool lean);

}  // namespace octacut
