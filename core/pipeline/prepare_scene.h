// What every reconstruction begins with: masks without false gaps, views
// prepared for a root cube, and borders of the masks where the photographs show
// them.
#pragma once

#include <optional>
#include <vector>

#include "core/base/context.h"
#include "core/hull/repaired_scene.h"
#include "core/scene/scene.h"
#include "core/views/border_edges.h"
#include "core/views/view_set.h"

namespace octacut {

struct MaskOptions {
  // Pixels of the photographs by which masks may be too small; 0 .. 64.
  double mask_tolerance = 2;
  // Fill gaps of masks that points or other views show to be false
  // (FillGapsAtPoints, FillFalseGaps).
  bool fill_false_gaps = true;
  // Move the borders of the masks to the edges of the photographs: those of
  // single masks that are off (FindMaskShifts), then all by the same pixels
  // (FindLargeShift, ShiftBordersToEdges), in refinement also by the occluding
  // contours.
  bool move_mask_borders = true;
  void Check() const;
};

struct PreparedScene {
  RepairedScene repaired;
  // Pixels by which the borders of its masks were moved, one per view.
  std::vector<double> moved_inwards;
  ViewSet views;  // of the repaired scene
  std::optional<BorderEdges> border_edges;
};

// Throws InputError for fewer than 3 views or too many of them, and where a
// view has no mask, or no image although it `needs_images`.
void CheckScene(const Scene& scene, bool needs_images);

// `options` are valid. Without `move_mask_borders`, or without images, the
// borders stay where they are.
PreparedScene PrepareScene(const Scene& scene,
                           const BoundingCube& cube,
                           const MaskOptions& options,
                           const Context& context);

}  // namespace octacut
