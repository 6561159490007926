// Labels of pixels, as in masks.
#pragma once

#include <cstdint>

namespace octacut {

inline constexpr uint8_t kSurroundingsLabel = 0;
inline constexpr uint8_t kNoLabel = 128;
inline constexpr uint8_t kObjectLabel = 255;

}  // namespace octacut
