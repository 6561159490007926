// Whether the photographs show the surface of the object, or what it mirrors.
//
// Views that look from several sides at a surface that scatters light agree
// about it, where the visual hull is near it. What a mirror shows lies
// somewhere else for each of them (docs/experiments/contradicting_depths.md).
#pragma once

#include "core/base/context.h"
#include "core/grid/labeled_voxels.h"
#include "core/refine/refine_options.h"
#include "core/views/view_set.h"

namespace octacut {

struct ShownSurface {
  // Agreement of the views about the hull's surface, in images as coarse as
  // half its voxels: -1 .. 1, exceeded around a tenth of its points.
  double agreement = 0;
  // How far the photographs show the surface, 0 .. 1.
  float share = 1;
};

// `hull` is the labelling of the hull's surface.
ShownSurface MeasureShownSurface(const ViewSet& views,
                                 const LabeledVoxels& hull,
                                 const RefineOptions& options,
                                 const Context& context);

}  // namespace octacut
