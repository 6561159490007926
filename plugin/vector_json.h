// Points and directions in reports: [x, y, z].
#pragma once

#include <Eigen/Core>

#include "plugin/option_value.h"

namespace octacut {

inline Json VectorToJson(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

}  // namespace octacut
