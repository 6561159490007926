// Where the silhouettes want the surface: at points where it turns away from a
// view, it ends at the border of the view's mask.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/mesh/vertex_corners.h"
#include "core/raycast/ray_scene.h"
#include "core/refine/local_surface.h"
#include "core/refine/solve_offsets.h"
#include "core/views/view_set.h"

namespace octacut {

// One target for each edge and view along which the fitted surface turns away
// from the view within `range` pixels of where the border of its mask should
// be: `border_shift` pixels outside of it. Targets are offsets of the fitted
// surface in unit coordinates; their weights are 1.
// Only where the mesh of `rays` ends in the view, and where the border is a
// plain step from object to background. `neighbors` are those of
// FindVertexNeighbors.
std::vector<EdgeTarget> FindRimTargets(
    const ViewSet& views,
    const RayScene& rays,
    const std::vector<LocalSurface>& surfaces,
    const VertexCorners& neighbors,
    double range,
    double border_shift,
    const Context& context);

}  // namespace octacut
