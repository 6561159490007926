// Places for charts on the pages of an atlas.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/texture/charts.h"

namespace octacut {

// Charts are placed on multiples of this many texels, and take as many.
inline constexpr int kPackingCell = 4;

struct PackOptions {
  int max_size = 8192;  // texels along the side of a page, at most
  int max_pages = 16;
};

struct ChartPlace {
  uint32_t page;
  int x, y;  // texels of the box's top-left corner
};

struct PageSize {
  int width;
  int height;
};

struct PackedCharts {
  std::vector<ChartPlace> places;  // of each chart
  std::vector<PageSize> pages;
};

// Charts, the largest ones first, each as far up as it goes below those that
// were placed before: the outlines of charts, not their boxes, are kept apart
// (as B. Levy et al., "Least Squares Conformal Maps", SIGGRAPH 2002). One page
// that is about square if all fit in it. Throws OptionError where a chart is
// larger than a page, and one that says how many pages would do where
// `max_pages` are too few.
PackedCharts PackCharts(const Charts& charts,
                        const PackOptions& options,
                        const Context& context);

}  // namespace octacut
