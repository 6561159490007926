// The octahedral cut without a graph: the voxel grid is the graph.
#pragma once

#include <span>

#include "core/cut/octahedral_cut.h"
#include "core/cut/voxel_walk.h"

namespace octacut {

// A checked problem and its merged ties (cut_problem.h), which are freed once
// they are no longer needed. Fills labels, cost_fixed_point (the flow) and
// num_nodes of the result. Throws InvariantError when a residual arc leaves
// the source side.
OctahedralCut SolveImplicitly(const OctahedralCutProblem& problem,
                              const VoxelWalk& walk,
                              const Context& context);

// Bytes SolveImplicitly and the proof need at their peak.
size_t EstimateImplicitCutBytes(size_t num_voxels, bool with_evidence);

}  // namespace octacut
