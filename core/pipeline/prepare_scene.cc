#include "core/pipeline/prepare_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "core/base/check_option.h"
#include "core/hull/false_gaps.h"
#include "core/hull/point_gaps.h"
#include "core/views/mask_shifts.h"

namespace octacut {
namespace {

// Views in a warning.
constexpr size_t kMaxNamed = 5;

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

// Names the largest ones.
void WarnOfMovedMasks(const RepairedScene& repaired, const Context& context) {
  std::vector<MaskShift> shifts = repaired.shifts;
  std::stable_sort(
      shifts.begin(), shifts.end(), [](const MaskShift& a, const MaskShift& b) {
        return std::abs(a.pixels) > std::abs(b.pixels);
      });
  std::string named;
  for (size_t i = 0; i < std::min(shifts.size(), kMaxNamed); ++i) {
    named += fmt::format("{}{} ({:.1f} pixels too {})",
                         i == 0 ? "" : ", ",
                         repaired.scene.views[shifts[i].view].name,
                         std::abs(shifts[i].pixels),
                         shifts[i].pixels > 0 ? "large" : "small");
  }
  context.Warn(fmt::format(
      "{} of {} masks are too large or too small, by their photographs and in "
      "comparison with the other masks: {}{}. Their borders are moved to "
      "where the photographs show the object's outline.",
      shifts.size(),
      repaired.scene.views.size(),
      named,
      shifts.size() > kMaxNamed ? " and others" : ""));
}

// Moves the borders of masks that are off by other pixels than most.
void MoveSingleBorders(const BoundingCube& cube,
                       const MaskOptions& options,
                       const Context& context,
                       PreparedScene* prepared) {
  RepairedScene& repaired = prepared->repaired;
  repaired.shifts = FindMaskShifts(prepared->views, context);
  if (repaired.shifts.empty()) {
    return;
  }
  for (const MaskShift& shift : repaired.shifts) {
    View& view = repaired.scene.views[shift.view];
    view.mask = MoveBorderInside(
        prepared->views[shift.view].silhouette, view.mask.size(), shift.pixels);
  }
  prepared->views =
      PrepareViews(repaired.scene, cube, context, options.mask_tolerance);
  WarnOfMovedMasks(repaired, context);
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
          : RepairedScene{scene, {}, {}};
  prepared.views = PrepareViews(
      prepared.repaired.scene, cube, context, options.mask_tolerance);
  if (options.move_mask_borders) {
    MoveSingleBorders(cube, options, context, &prepared);
    prepared.border_edges = ShiftBordersToEdges(context, &prepared.views);
  } else {
    KeepBorders(&prepared.views);
  }
  return prepared;
}

}  // namespace octacut
