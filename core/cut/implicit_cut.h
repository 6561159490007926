// The octahedral cut without a graph: the voxel grid is the graph.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/cut/fixed_point.h"
#include "core/cut/octahedral_cut.h"
#include "core/cut/voxel_walk.h"

namespace octacut {

// Told by the thread that does it when work on regions [begin, end) begins and
// ends: one region alone, or the search after two halves were joined.
using SearchObserver =
    std::function<void(size_t begin, size_t end, bool begins)>;

// How to search; all but the scale changes the time, never the result.
struct SearchPlan {
  // Regions of about so many voxels are searched alone, then joined pairwise.
  uint32_t region_voxels = 1 << 15;
  // Any other than the finest makes flows of 16 bits; the greatest weight is
  // then at most kMaxLeanWeight.
  CutScale scale = {};
  SearchObserver observer = nullptr;
};

// The plan that measurements speak for (docs/cut_engine.md).
SearchPlan PlanSearch(std::span<const FaceTies> merged_ties);

// Solves a problem whose values are checked (cut_problem.h). Its merged ties
// are freed during the search and made again after it. Fills labels,
// cost_fixed_point (the flow) and num_nodes of the result, which depend
// neither on the plan nor on the number of threads. Throws InvariantError
// when a residual arc leaves the source side.
OctahedralCut SolveImplicitly(const OctahedralCutProblem& problem,
                              const VoxelWalk& walk,
                              std::vector<FaceTies>& merged_ties,
                              const SearchPlan& plan,
                              const Context& context);

// Bytes SolveImplicitly and the proof need at their peak.
size_t EstimateImplicitCutBytes(size_t num_voxels,
                                bool with_evidence,
                                bool lean);

}  // namespace octacut
