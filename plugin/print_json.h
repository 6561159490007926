// What prints need, as members of a report.
#pragma once

#include <array>
#include <Eigen/Core>

#include "core/print/overhangs.h"
#include "core/print/wall_thickness.h"
#include "plugin/option_value.h"

namespace octacut {

inline Eigen::Vector3d ToVector(const std::array<double, 3>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

// {"measured_share", "min", "percentile_1", "percentile_5", "median", "max",
//  "thin_share", "histogram": [shares of equal bins up to max], "thinnest":
//  [{"point": [x, y, z], "thickness"}, ...]}
Json WallThicknessToJson(const WallThickness& walls);

// {"area", "share", "base_area"}
Json OverhangsToJson(const Overhangs& overhangs);

}  // namespace octacut
