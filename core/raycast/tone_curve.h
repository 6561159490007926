// From linear light to the eight bits of an image.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace octacut {

// sRGB's encoding of linear light in [0, 1]; more is clipped.
class ToneCurve {
 public:
  ToneCurve() {
    for (size_t i = 0; i < table_.size(); ++i) {
      table_[i] = static_cast<uint8_t>(std::lround(
          255 * Encode((static_cast<double>(i) + 0.5) / table_.size())));
    }
  }

  uint8_t operator()(float linear) const {
    const float scaled = linear * static_cast<float>(table_.size());
    return table_[static_cast<size_t>(
        std::clamp(scaled, 0.0f, static_cast<float>(table_.size() - 1)))];
  }

  static double Encode(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear
                               : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  }
  static double Decode(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92
                              : std::pow((encoded + 0.055) / 1.055, 2.4);
  }

 private:
  std::array<uint8_t, 8192> table_;
};

}  // namespace octacut
