#include "core/pipeline/prepare_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "core/base/check_option.h"
#include "core/base/error.h"
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

std::string DescribeShift(double pixels) {
  return fmt::format(
      "{:.1f} pixels too {}", std::abs(pixels), pixels > 0 ? "large" : "small");
}

// Names the largest ones.
void WarnOfSingleMasks(std::vector<MaskShift> shifts,
                       const std::vector<View>& views,
                       const Context& context) {
  std::stable_sort(
      shifts.begin(), shifts.end(), [](const MaskShift& a, const MaskShift& b) {
        return std::abs(a.pixels) > std::abs(b.pixels);
      });
  std::string named;
  for (size_t i = 0; i < std::min(shifts.size(), kMaxNamed); ++i) {
    named += fmt::format("{}{} ({})",
                         i == 0 ? "" : ", ",
                         views[shifts[i].view].name,
                         DescribeShift(shifts[i].pixels));
  }
  context.Warn(fmt::format(
      "The photographs indicate that {} of {} masks are too large or too "
      "small, unlike the other masks: {}{}. Their borders are moved to where "
      "the photographs show the object's outline.",
      shifts.size(),
      views.size(),
      named,
      shifts.size() > kMaxNamed ? " and others" : ""));
}

void MoveMasks(const std::vector<MaskShift>& shifts,
               const BoundingCube& cube,
               const MaskOptions& options,
               const Context& context,
               PreparedScene* prepared) {
  RepairedScene& repaired = prepared->repaired;
  for (const MaskShift& shift : shifts) {
    View& view = repaired.scene.views[shift.view];
    view.mask = MoveBorderInside(
        prepared->views[shift.view].silhouette, view.mask.size(), shift.pixels);
    prepared->moved_inwards[shift.view] += shift.pixels;
  }
  prepared->views =
      PrepareViews(repaired.scene, cube, context, options.mask_tolerance);
}

// The masks that are off by other pixels than most, then all masks, if they are
// far off, then all borders to what the edges say.
void MoveBorders(const BoundingCube& cube,
                 const MaskOptions& options,
                 const Context& context,
                 PreparedScene* prepared) {
  ViewSet& views = prepared->views;
  const std::vector<MaskShift> single = FindMaskShifts(views, context);
  if (!single.empty()) {
    MoveMasks(single, cube, options, context, prepared);
    WarnOfSingleMasks(single, prepared->repaired.scene.views, context);
  }
  std::optional<BorderEdges>& edges = prepared->border_edges;
  edges = MeasureBorderEdges(views, context);
  const CoarseShift large = FindLargeShift(views, edges, context);
  if (large.shift) {
    std::vector<MaskShift> all;
    for (size_t i = 0; i < views.size(); ++i) {
      all.push_back({i, *large.shift});
    }
    MoveMasks(all, cube, options, context, prepared);
    context.Warn(fmt::format(
        "The photographs indicate that all masks are about {}. Their borders "
        "are moved to where the photographs show the object's outline.",
        DescribeShift(*large.shift)));
    edges = MeasureBorderEdges(views, context);
  }
  ShiftBordersToEdges(edges, large.is_doubted, &views);
}

}  // namespace

void MaskOptions::Check() const {
  CheckOption(mask_tolerance >= 0 && mask_tolerance <= kMaxMaskTolerance,
              "mask_tolerance",
              mask_tolerance,
              fmt::format("must be in 0 .. {}", kMaxMaskTolerance));
}

void CheckScene(const Scene& scene, bool needs_images) {
  if (scene.views.size() < 3) {
    throw InputError(fmt::format("{} views are too few: at least 3 are needed",
                                 scene.views.size()));
  }
  // Lists of views that see a point hold numbers of 16 bits.
  if (scene.views.size() > std::numeric_limits<uint16_t>::max()) {
    throw InputError(
        fmt::format("{} views are too many: at most {} can be used",
                    scene.views.size(),
                    std::numeric_limits<uint16_t>::max()));
  }
  for (const View& view : scene.views) {
    if (needs_images && view.image.empty()) {
      throw InputError(view.name + ": the view has no image");
    }
    if (view.mask.empty()) {
      throw InputError(view.name + ": the view has no mask");
    }
  }
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
  prepared.moved_inwards.resize(prepared.views.size());
  if (options.move_mask_borders) {
    MoveBorders(cube, options, context, &prepared);
  } else {
    KeepBorders(&prepared.views);
  }
  return prepared;
}

}  // namespace octacut
