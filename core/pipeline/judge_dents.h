// Where a cut lies inside of the visual hull, and the views agree no better
// about it than about the hull.
//
// Depths of the object lead a cut into its hollows. Noise, highlights and
// reflections, which agree by chance, lead it astray, so that plain and glazed
// objects get pits. Which of them it was the photographs tell when they are
// asked about both surfaces: where the cut is right, views agree about it, and
// less about what the hull has in front of it (docs/experiments/dents.md).
#pragma once

#include "core/base/context.h"
#include "core/evidence/depth_confidence.h"
#include "core/grid/labeled_voxels.h"
#include "core/refine/refine_options.h"
#include "core/views/view_set.h"

namespace octacut {

// The depths in all views of what `cut` has inside of `hull`, labellings of one
// level, and how far they can be relied upon (0 .. 1): by how much more the
// views agree about the cut than about the hull on the same line of sight. At
// the samples of `maps`.
ReliableDepths JudgeDents(const ViewSet& views,
                          const LabeledVoxels& hull,
                          const LabeledVoxels& cut,
                          const std::vector<SweptDepthMap>& maps,
                          const RefineOptions& options,
                          const Context& context);

}  // namespace octacut
