// The visual hull's surface at any level, as a labelling that the manifold
// extraction takes: faces are inside where their centre is object in every
// view, so the surface is not inflated by the voxels' footprints.
#pragma once

#include "core/base/context.h"
#include "core/grid/labeled_voxels.h"
#include "core/hull/visual_hull.h"
#include "core/views/view_set.h"

namespace octacut {

// A labelled crust around the surface of the hull at the level of `octree`,
// which RefineHull has made of the same views and box.
LabeledVoxels ComputeHullSurface(const ViewSet& views,
                                 const Eigen::AlignedBox3f& box,
                                 const HullOctree& octree,
                                 const Context& context);

// The same at options.hull_level. Throws InputError when the hull is empty.
LabeledVoxels ComputeHullSurface(const ViewSet& views,
                                 const Eigen::AlignedBox3f& box,
                                 const VisualHullOptions& options,
                                 const Context& context);

}  // namespace octacut
