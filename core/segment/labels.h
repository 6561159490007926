// Labels of pixels, as in masks.
#pragma once

#include <cstdint>

namespace octacut {

inline constexpr uint8_t kSurroundings = 0;
inline constexpr uint8_t kNothingSaid = 128;
inline constexpr uint8_t kObject = 255;

}  // namespace octacut
