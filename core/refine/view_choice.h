// Which views see each point of a surface, by rays.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/raycast/ray_scene.h"
#include "core/refine/local_surface.h"
#include "core/views/view_set.h"

namespace octacut {

struct ViewChoiceOptions {
  // Views at more than this angle (degrees) to the normal do not count. 72 is
  // worse, 85 loses thin rods: docs/experiments/refinement_concavities.md.
  double max_angle = 80;
  // At most this many views per point, those of most weight; 2 .. 24. With 24
  // errors hardly fall: docs/experiments/refinement_patches.md.
  int max_views = 16;
  // Between the directions of any two of them, degrees: nearly equal views
  // tell nothing about depth. Not varied alone; the depth sweep has the same.
  double min_separation = 4;
  void Check() const;
};

struct ChosenViews {
  static constexpr int kMaxViews = 24;
  std::array<uint16_t, kMaxViews> views;  // of most weight first
  // Cosines to the normal: what is foreshortened tells less. Where a view's
  // pixel is larger than LinesOfSight::pixel, times the square of the ratio of
  // both, because its depths are that much less precise.
  std::array<float, kMaxViews> weights;
  uint8_t count = 0;
  float pixel = 0;  // weighted mean size of their pixels at the point
};

// The rays that have to reach a camera; lengths in unit coordinates.
struct LinesOfSight {
  // Pixels of views that are larger than that are too large.
  double pixel = 1;
  // They begin this far before the surface.
  double clearance = 0;
  // As must those from a ring around the point, of so many pixels of the view,
  // where it faces the camera: a patch that is hidden in part draws the surface
  // towards what hides it, out of every concavity. 0: no ring.
  double ring_radius = 0;
  double ring_clearance = 0;
  // The radius of patches, unit coordinates. Views to which not all of the
  // patch is turned as ViewChoiceOptions::max_angle says, because the surface
  // curves away, only count where others are few
  // (docs/experiments/refinement_patches.md).
  double patch_radius = 0;
};

// One choice a point. A view counts when the point is within its frame, on
// its silhouette's object and not hidden: none of `lines` meets `rays`.
// Coordinates are unit coordinates throughout, those of `rays` too.
std::vector<ChosenViews> ChooseViews(const ViewSet& views,
                                     const RayScene& rays,
                                     const std::vector<LocalSurface>& surfaces,
                                     const LinesOfSight& lines,
                                     const ViewChoiceOptions& options,
                                     const Context& context);

}  // namespace octacut
