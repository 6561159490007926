#include "core/hull/repair_masks.h"

#include "core/hull/false_gaps.h"
#include "core/hull/point_gaps.h"

namespace octacut {

RepairedScene RepairMasks(const Scene& scene,
                          const BoundingCube& cube,
                          double mask_tolerance,
                          bool fill_false_gaps,
                          const Context& context) {
  if (!fill_false_gaps) {
    return {scene, {}};
  }
  // Points first: views that share a shadow confirm each other's gaps.
  const RepairedScene at_points =
      FillGapsAtPoints(scene, mask_tolerance, context);
  RepairedScene repaired =
      FillFalseGaps(at_points.scene, cube, mask_tolerance, context);
  repaired.gaps.insert(
      repaired.gaps.begin(), at_points.gaps.begin(), at_points.gaps.end());
  return repaired;
}

}  // namespace octacut
