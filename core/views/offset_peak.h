// Offsets of edges from the borders of masks, many of which lie anywhere.
#pragma once

#include <optional>
#include <vector>

namespace octacut {

// Pixels.
struct OffsetPeak {
  double center = 0;
  double deviation = 0;  // median distance from it
  double share = 0;      // of the offsets that are within a pixel
};

// The median of the most frequent of the offsets, which lie within kEdgeRange.
// None if fewer than a hundred, or than `min_share`, lie within a pixel of it.
std::optional<OffsetPeak> FindOffsetPeak(const std::vector<float>& offsets,
                                         double min_share);

}  // namespace octacut
