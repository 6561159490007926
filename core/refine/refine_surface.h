// Photometric refinement: vertices move along their normals to where the views
// agree best, below the size of a voxel.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/refine/align_views.h"
#include "core/refine/refine_options.h"
#include "core/refine/refine_round.h"
#include "core/scene/scene.h"
#include "core/views/view_set.h"

namespace octacut {

struct RefineSummary {
  double pixel_size = 0;  // of the views at the surface, world units
  size_t num_vertices = 0;
  size_t num_moved = 0;
  double mean_displacement = 0;  // of the moved ones, pixels
  double max_displacement = 0;
  // Pixels by which the masks' borders are taken to lie too far outside; where
  // nothing could be measured, that of the views.
  double border_shift = 0;
  // Mean agreement over what the views show (SurfaceAgreement::Mean).
  double agreement_before = 0;
  double agreement_after = 0;
  // In all rounds, and where positions are rounded to floats.
  size_t num_withdrawn = 0;
  ViewMotion view_motion;  // of the alignment, at the surface
  std::vector<RoundSummary> rounds;
  double seconds = 0;
};

struct RefinedSurface {
  IndexedMesh mesh;  // with normals; colours as they were
  RefineSummary summary;
};

// `mesh` is closed and oriented, in world coordinates; `views` are those of
// PrepareViews for `cube`, with images; their poses are aligned. Topology
// stays. Vertices that no two views see, and are not close to such that do,
// keep their positions exactly. No two triangles intersect that did not before,
// and none becomes degenerate. Throws InputError when a view has no image,
// there are fewer than two, or the mesh has no triangle or is behind them all.
RefinedSurface RefineSurface(IndexedMesh mesh,
                             const BoundingCube& cube,
                             const RefineOptions& options,
                             const Context& context,
                             ViewSet* views);

// Whether to go on, where the coarse rounds have moved the vertices: unit
// coordinates.
using CoarseCheck = std::function<bool(const std::vector<Eigen::Vector3d>&)>;

// The same; none, and the views as they were, if `goes_on` says no. It is asked
// after the coarse rounds, which show roughly how far the surface will move.
std::optional<RefinedSurface> RefineSurfaceIf(const CoarseCheck& goes_on,
                                              IndexedMesh mesh,
                                              const BoundingCube& cube,
                                              const RefineOptions& options,
                                              const Context& context,
                                              ViewSet* views);

// Bytes that RefineSurface will need at its peak, roughly.
size_t EstimateRefinementBytes(size_t num_vertices);

}  // namespace octacut
