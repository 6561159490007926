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

// Those less than a pixel from `center`.
std::vector<float> WithinAPixel(const std::vector<float>& offsets,
                                float center);

// The median of the most frequent of the offsets, which lie within kEdgeRange.
// None if fewer than a hundred, or than `min_share`, lie within a pixel of it.
std::optional<OffsetPeak> FindOffsetPeak(const std::vector<float>& offsets,
                                         double min_share);

// The median of those that lie within a pixel of `center`. None if these are
// fewer than a hundred.
std::optional<OffsetPeak> PeakAround(double center,
                                     const std::vector<float>& offsets);

// The most frequent of the offsets, which lie within `range`, to a quarter of a
// pixel. None if there are fewer than a hundred, if it is not clearly more
// frequent than those beside it, or if another peak is comparable to it.
std::optional<float> FindLonePeak(const std::vector<float>& offsets,
                                  float range);

// The height of the highest peak within `reach` of `center`: offsets per
// quarter of a pixel, less those beside it; at least 0. All offsets are within
// `range`.
float PeakHeight(const std::vector<float>& offsets,
                 float range,
                 float center,
                 float reach);

}  // namespace octacut
