#include "core/pipeline/prepare_scene.h"

#include <fmt/format.h>

#include "core/base/check_option.h"
#include "core/hull/false_gaps.h"
#include "core/hull/point_gaps.h"

namespace octacut {
namespace {

RepairedScene RepairMasks(const Scene& scene,
                          const BoundingCube& cube,
                          double mask_tolerance,
                          const Context& context) {
  // Points first: views that share a shadow confirm each other's gaps.
  const RepairedScene at_points =
      FillGapsAtPoints(scene, mask_tolerance, context);
  RepairedScene repaired =
      FillFalseGaps(at_points.scene, cube, mask_tolerance, context);
  repaired.gaps.insert(
      repaired.gaps.begin(), at_points.gaps.begin(), at_points.gaps.end());
  return repaired;
}

}  // namespace

void MaskOptions::Check() const {
  CheckOption(mask_tolerance >= 0 && mask_tolerance <= kMaxMaskTolerance,
              "mask_tolerance",
              mask_tolerance,
              fmt::format("must be in 0 .. {}", kMaxMaskTolerance));
}

PreparedScene PrepareScene(const Scene& scene,
                           const BoundingCube& cube,
                           const MaskOptions& options,
                           const Context& context) {
  PreparedScene prepared;
  prepared.repaired =
      options.fill_false_gaps
          ? RepairMasks(scene, cube, options.mask_tolerance, context)
          : RepairedScene{scene, {}};
  prepared.views = PrepareViews(
      prepared.repaired.scene, cube, context, options.mask_tolerance);
  if (options.move_mask_borders) {
    prepared.border_edges = ShiftBordersToEdges(context, &prepared.views);
  } else {
    KeepBorders(&prepared.views);
  }
  return prepared;
}

}  // namespace octacut
