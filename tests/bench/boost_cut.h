// The reference implementation of the octahedral cut: an explicit graph and
// Boost's Boykov-Kolmogorov maximum flow [Boykov & Kolmogorov PAMI 2004].
#pragma once

#include <span>

#include "core/cut/octahedral_cut.h"

namespace octacut {

// A checked problem and its merged ties (cut_problem.h). Fills labels,
// cost_fixed_point (the flow) and num_nodes of the result.
OctahedralCut SolveWithBoost(const OctahedralCutProblem& problem,
                             std::span<const FaceTies> merged_ties);

}  // namespace octacut
