// Photometric alignment of the views: poses of a sparse model are off by
// fractions of a pixel, which blurs where the views agree. Each view is moved
// so that its image of the surface fits the mean image of all views.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/context.h"
#include "core/refine/local_surface.h"
#include "core/refine/surface_patch.h"
#include "core/refine/view_choice.h"
#include "core/views/view_set.h"

namespace octacut {

// One Gauss-Newton step of all poses at once; `surfaces` are seen by
// `choices`, the samples of a patch a pixel apart. What all views would do
// alike (a turn, a shift, a growth of the whole scene) is taken out, so that
// they stay where they are in the mean. Views that show too little of what
// agrees are moved by that alone. Returns the number of views that were
// aligned.
size_t AlignViews(const std::vector<LocalSurface>& surfaces,
                  const std::vector<ChosenViews>& choices,
                  const PatchOptions& patch_options,
                  const Context& context,
                  ViewSet* views);

// By how many pixels the images of `points` (unit coordinates) differ.
struct ViewMotion {
  double mean = 0;  // over all views and the points before them
  double max = 0;   // of a view's mean
};
ViewMotion MeasureViewMotion(const std::vector<ViewProjection>& before,
                             const ViewSet& views,
                             const std::vector<Eigen::Vector3d>& points);

}  // namespace octacut
