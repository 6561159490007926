// What prints need, as members of a report.
#pragma once

#include "core/print/overhangs.h"
#include "core/print/wall_thickness.h"
#include "plugin/option_value.h"

namespace octacut {

// {"measured_share", "min", "percentile_1", "percentile_5", "median", "max",
//  "thin_share", "histogram": [shares of equal bins up to max], "thinnest":
//  [{"point": [x, y, z], "thickness"}, ...]}
Json WallThicknessToJson(const WallThickness& walls);

// {"area", "share", "base_area"}
Json OverhangsToJson(const Overhangs& overhangs);

}  // namespace octacut
