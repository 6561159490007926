// Where the silhouettes want the surface: at points where it turns away from a
// view, it ends at the border of the view's mask.
#pragma once

#include <optional>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/vertex_corners.h"
#include "core/raycast/ray_scene.h"
#include "core/refine/local_surface.h"
#include "core/refine/solve_offsets.h"
#include "core/views/view_set.h"

namespace octacut {

struct ContourTarget {
  EdgeTarget edge;  // unit coordinates; its weight is 1
  // Pixels of the view by which a unit of offset moves the occluding contour.
  float pixels_per_unit;
};

// Pixels of each view.
struct ContourSearch {
  double range = 0;         // of the border from the contour
  double border_shift = 0;  // by which borders lie too far outside
};

// One for each edge and view along which the fitted surface turns away from the
// view within the range of where the border of its mask should be. Targets are
// offsets of the fitted surface that bring its outline, which may pass outside
// of the edge where normals are noisy, to the border. Pixels are those of each
// view. Only where the mesh of `rays` ends in the view, and where the border is
// a plain step from object to background. `surfaces` are those of points,
// `neighbors` those of SurfacePoints.
std::vector<ContourTarget> FindContourTargets(
    const ViewSet& views,
    const RayScene& rays,
    const std::vector<LocalSurface>& surfaces,
    const VertexCorners& neighbors,
    const ContourSearch& search,
    const Context& context);

// The median distance of the surface's occluding contours from where the
// borders of the masks want them, pixels of the views; nothing without
// occluding contours. Where masks and poses agree with one another it is a
// fraction of a pixel, since a surface can end at all borders at once; where
// they do not, no surface can.
std::optional<double> MedianDistance(
    const std::vector<ContourTarget>& contours);

}  // namespace octacut
