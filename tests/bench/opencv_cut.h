// A peer for measurements: the octahedral cut by OpenCV's GCGraph.
#pragma once

#include <span>

#include "core/cut/octahedral_cut.h"

namespace octacut {

// Fills labels, cost_fixed_point (the flow) and num_nodes. The labels are
// GCGraph's own choice among the minimum cuts, as far as it finds one.
OctahedralCut SolveWithOpenCv(const OctahedralCutProblem& problem,
                              std::span<const FaceTies> merged_ties);

}  // namespace octacut
