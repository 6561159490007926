// Where a cut lies inside of the visual hull, and the views agree no better
// about it than about the hull.
//
// Depths of the object lead a cut into its hollows. Noise, highlights and
// reflections, which agree by chance, lead it astray, so that plain and glazed
// objects get pits. Measuring both surfaces in the photographs tells the two
// apart: where the cut is right, the views agree better about it than about the
// hull in front of it. The agreement about highlights, which lie behind the
// surface for all views that see them, tells nothing: where the views show no
// detail, and the object is not matt, the hull is the better guess
// (docs/experiments/dents.md).
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/evidence/depth_sweep.h"
#include "core/evidence/inside_evidence.h"
#include "core/grid/labeled_voxels.h"
#include "core/refine/refine_options.h"
#include "core/views/view_set.h"

namespace octacut {

// Finds the samples of `maps`, with the `detail` that SweepDepths gives them,
// within the silhouettes whose line of sight meets `cut` at least half a voxel
// behind `hull`, labellings of one level. Returns maps of the same size: at
// these samples the depth of the cut (along the optical axis, unit
// coordinates), and a confidence of 0 .. 1 that grows with how much better the
// views agree about the cut than about the hull; elsewhere depth 0. It is
// multiplied by the detail unless points of the hull without detail look matt
// (core/refine/mattness.h). Where no two views see the cut, their agreement
// about it is 0. In unfounded pits (core/pipeline/unfounded_pits.h), the
// confidence is 0 and `in_pit` is 1. Left out are samples where no two views
// see the hull, and those whose own depth lies far behind the cut, unless the
// views agree well about the hull or there is no detail on what is not matt.
// `scene_confidence` is 1: without judged samples, a cut is sure.
SurfaceVerdict JudgeDents(const ViewSet& views,
                          const LabeledVoxels& hull,
                          const LabeledVoxels& cut,
                          const std::vector<SweptDepthMap>& maps,
                          const RefineOptions& options,
                          const Context& context);

}  // namespace octacut
