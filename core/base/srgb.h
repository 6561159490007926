// sRGB's encoding of linear light, both in [0, 1].
#pragma once

#include <cmath>

namespace octacut {

inline double EncodeSrgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear
                             : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

inline double DecodeSrgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92
                            : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace octacut
