// One round of refinement: fit, measure, solve, move.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/vertex_corners.h"
#include "core/refine/agreement.h"
#include "core/refine/refine_options.h"
#include "core/views/view_set.h"

namespace octacut {

struct RoundSummary {
  double scale = 0;  // size of the round's pixels in those of the views
  double range = 0;  // of the search, pixels of the views
  size_t num_points = 0;
  size_t num_seen = 0;      // of them, by two views, in RoundInputs::part
  size_t num_measured = 0;  // of them, with an offset that others support
  size_t num_contour_targets = 0;  // from silhouettes
  // Pixels by which the masks' borders are taken to lie too far outside, after
  // the round; shrunk by the noise of what it measured.
  double border_shift = 0;
  // Pixels by which vertices may leave a mask.
  double hull_tolerance = 0;
  double mean_displacement = 0;  // of the vertices that may move, pixels
  size_t num_aligned = 0;        // views, in the last step
  // The share of the moves, in RoundInputs::part, that was taken back because
  // the views agreed less, or on smaller pieces (narrow_rounds.h) no better.
  double taken_back = 0;
  // Vertices that were moved back: into the hull, or for the sake of
  // triangles that were too thin or intersected others.
  size_t num_withdrawn = 0;
  double agreement_seconds = 0;  // of the views, before and after
  double look_seconds = 0;
  double alignment_seconds = 0;
  double search_seconds = 0;
  double silhouette_seconds = 0;
  double solve_seconds = 0;
  double validity_seconds = 0;

  // Pixels by which vertices may leave a mask as it is given, which may be too
  // small.
  double MaskTolerance() const {
    return hull_tolerance + std::max(0.0, -border_shift);
  }
  // Where most points have no offset, those of the others may be chance, and
  // neither poses nor the masks' borders are judged by them.
  bool KnowsMost() const { return 2 * num_measured > num_seen; }
};

struct RoundPlan {
  double scale = 1;  // of the round's pixels, in pixels of the views
  double range = 0;  // of the search, in the round's pixels
  // Whether vertices come to lie on the fitted surface; else they keep their
  // distances from it.
  bool smooths = true;
  bool aligns = false;  // the views, first
  // The shift of the masks' borders as found by an earlier round, pixels of the
  // views.
  double border_shift = 0;
  // The shift of the borders by the edges of the photographs, pixels, and how
  // far occluding contours may lead away from it.
  double edge_shift = 0;
  double edge_shift_slack = std::numeric_limits<double>::infinity();

  // Smoothing coarsely loses narrow folds.
  bool CanHarm() const { return smooths && scale > 1; }
};

// What all rounds of a refinement share; unit coordinates.
struct RoundInputs {
  // Positions of the vertices before the first round.
  const std::vector<Eigen::Vector3d>& start;
  const VertexCorners& neighbors;  // as FindVertexNeighbors has them
  double pixel;                    // size of one of the views at the surface
  const RefineOptions& options;
  // Vertices that are looked at and may move, one element each; empty: all.
  std::span<const uint8_t> part = {};
};

// Aligns `views` if it is to, moves the vertices of `mesh` (unit
// coordinates) as far as it stays valid, and leaves normals that belong to no
// positions in particular. `agreement` is that of the views about the mesh as
// it is; null is allowed unless the plan can harm.
RoundSummary RefineOnce(const RoundInputs& inputs,
                        const RoundPlan& plan,
                        const SurfaceAgreement* agreement,
                        const Context& context,
                        ViewSet* views,
                        IndexedMesh* mesh);

}  // namespace octacut
