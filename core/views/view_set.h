// The views of a scene, prepared for a given root cube: projections,
// silhouettes and image pyramids. Built once, read by every step.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "core/base/context.h"
#include "core/scene/scene.h"
#include "core/views/image_pyramid.h"
#include "core/views/silhouette.h"
#include "core/views/view_projection.h"

namespace octacut {

struct PreparedView {
  ViewProjection projection;
  Silhouette silhouette;
  ImagePyramid pyramid;
  // Pixels of the view by which its mask may be too small: what is that near
  // to the object is not surely outside.
  float mask_tolerance = 0;
  // Pixels by which the border of the mask lies outside the edges that the
  // photographs show (ShiftBordersToEdges).
  float border_shift = 0;
  // Pixels by which refinement may move the border from there.
  float border_shift_slack = std::numeric_limits<float>::infinity();

  // Pixels from the border of the mask, as shifted, to a point of the view;
  // negative outside of the object.
  float DistanceInside(const ProjectedPoint& p) const {
    return silhouette.SignedDistance(p.u, p.v) - border_shift;
  }

  // A point this many pixels inside the border of the mask is surely object:
  // the error of the border, and one pixel for sampling (half for the mask,
  // half for the ray through the middle of a pixel).
  float SureDepth() const {
    return 1 + mask_tolerance + std::max(0.0f, border_shift);
  }
};

using ViewSet = std::vector<PreparedView>;

// Views without an image (silhouettes alone) get no pyramid. `mask_tolerance`
// is in pixels of the photographs.
ViewSet PrepareViews(const Scene& scene,
                     const BoundingCube& cube,
                     const Context& context,
                     double mask_tolerance = 0);

// Of all views, in their order: what refinement aligns.
std::vector<ViewProjection> Projections(const ViewSet& views);
void SetProjections(const std::vector<ViewProjection>& projections,
                    ViewSet* views);

// Size of a pixel at a point, unit coordinates: the mean over the views that
// have the point before them, weighted by the squares of their pixels per unit,
// so that distant ones hardly count; 0 when none has.
double PixelSize(const ViewSet& views, const Eigen::Vector3f& point);

// Bytes that PrepareViews will need for the views of a scene, roughly.
size_t EstimateViewBytes(const Scene& scene);

}  // namespace octacut
