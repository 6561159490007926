#include "core/segment/turntable_views.h"

#include <fmt/format.h>

#include <opencv2/core.hpp>
#include <utility>
#include <vector>

#include "core/segment/above_plate.h"

namespace octacut {
namespace {

// Part of what turns above the plate that others may contradict. Borders and
// pieces of background are 0.2 to 2.8 % in thirteen sequences, 4.4 % of thin
// rods; lost heads and fingers are 11 and 16 %
// (docs/experiments/mask_turntables.md).
constexpr double kMostContradicted = 0.07;

}  // namespace

void UseTurntable(const SearchRegion& region,
                  const Context& context,
                  SegmentationInput* input) {
  std::vector<UnsegmentedView*> views;
  std::vector<cv::Mat> labels;
  std::vector<Pose> poses;
  for (UnsegmentedView& view : input->views) {
    if (view.is_turntable) {
      views.push_back(&view);
      labels.push_back(view.labels);
      poses.push_back(view.pose);
    }
  }
  if (views.empty()) {
    return;
  }
  std::vector<cv::Mat> above =
      FindPixelsAbovePlate(labels, poses, *input->floor, context);
  const double contradicted =
      ContradictedPart(labels, above, poses, *input->floor, region, context);
  if (contradicted > kMostContradicted) {
    context.Warn(fmt::format(
        "The masks of the turntable contradict each other: for {:.0f} % of the "
        "pixels that they show above the plate, other masks leave no object on "
        "the line of sight. Parts of the object probably look like the "
        "background. These masks are not used.",
        100 * contradicted));
  }
  for (size_t i = 0; i < views.size(); ++i) {
    if (contradicted > kMostContradicted) {
      views[i]->labels.release();
      views[i]->is_turntable = false;
    } else {
      views[i]->above_plate = std::move(above[i]);
    }
  }
}

}  // namespace octacut
