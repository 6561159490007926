// Which views a view is compared with.
#pragma once

#include <vector>

#include "core/views/view_set.h"

namespace octacut {

// For each view at most `count` others whose direction from the cube's centre
// differs by min_angle .. max_angle (degrees), best first. Wide enough to tell
// depths apart and near enough to look alike: about 15 degrees is best.
std::vector<std::vector<int>> SelectNeighborViews(const ViewSet& views,
                                                  int count,
                                                  double min_angle,
                                                  double max_angle);

}  // namespace octacut
