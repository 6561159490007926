#include "core/hull/repaired_scene.h"

#include <fmt/format.h>

#include <algorithm>

namespace octacut {

void ReportGaps(const RepairedScene& repaired,
                std::string_view reason,
                const Context& context) {
  if (repaired.gaps.empty()) {
    return;
  }
  const FalseGap& largest =
      *std::max_element(repaired.gaps.begin(),
                        repaired.gaps.end(),
                        [](const FalseGap& a, const FalseGap& b) {
                          return a.num_pixels < b.num_pixels;
                        });
  context.Info(fmt::format(
      "Filled {} gaps in the masks because {} there. The largest gap has {} "
      "pixels and is in the mask of {}.",
      repaired.gaps.size(),
      reason,
      largest.num_pixels,
      repaired.scene.views[largest.view].name));
}

}  // namespace octacut
