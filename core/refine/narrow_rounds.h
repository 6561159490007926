// Rounds for what is narrower than the pieces of the surface that other rounds
// assume smooth: folds, edges, reliefs.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/refine/refine_round.h"
#include "core/views/view_set.h"

namespace octacut {

// Moves the vertices of `mesh` (unit coordinates) in passes of rounds at the
// views' own scale, with smaller pieces and less smoothness. After each pass,
// moves stay where the views agree significantly better than before it, and
// are taken back elsewhere: smaller pieces follow the noise of the photographs.
// Passes go on while much of what they look at gains: folds open a little
// farther each time. The first one looks at the whole surface, later ones only
// around what has gained (docs/experiments/refinement_narrow.md). `plan` has
// the shift of the masks' borders and is at the views' own scale; its range
// does not matter.
// Appends to `rounds`, which holds those before; none where hardly any point
// had an offset in the last of them.
void RefineNarrowParts(const RoundInputs& inputs,
                       RoundPlan plan,
                       const Context& context,
                       ViewSet* views,
                       IndexedMesh* mesh,
                       std::vector<RoundSummary>* rounds);

}  // namespace octacut
