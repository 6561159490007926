// A linear step from 0 to 1.
#pragma once

#include <algorithm>

namespace octacut {

// 0 up to `zero` and 1 from `one` on, linear between them; `one` may be less
// than `zero`.
inline float Ramp(float value, float zero, float one) {
  return std::clamp((value - zero) / (one - zero), 0.0f, 1.0f);
}

}  // namespace octacut
