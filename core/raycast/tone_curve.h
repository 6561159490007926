// From linear light to the eight bits of an image, by a table.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/base/srgb.h"

namespace octacut {

// sRGB's encoding of linear light in [0, 1]; more is clipped.
class ToneCurve {
 public:
  ToneCurve() {
    for (size_t i = 0; i < table_.size(); ++i) {
      table_[i] = static_cast<uint8_t>(std::lround(
          255 * EncodeSrgb((static_cast<double>(i) + 0.5) / table_.size())));
    }
  }

  uint8_t operator()(float linear) const {
    const float scaled = linear * static_cast<float>(table_.size());
    if (!(scaled > 0)) {  // nor a number
      return table_.front();
    }
    return table_[static_cast<size_t>(
        std::min(scaled, static_cast<float>(table_.size() - 1)))];
  }

 private:
  std::array<uint8_t, 8192> table_;
};

}  // namespace octacut
