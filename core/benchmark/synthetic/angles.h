// Degrees, which scenes and rigs are described in.
#pragma once

#include <numbers>

namespace octacut {

inline double Radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

}  // namespace octacut
