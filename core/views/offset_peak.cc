#include "core/views/offset_peak.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/median.h"
#include "core/views/border_lines.h"

namespace octacut {
namespace {

constexpr size_t kMinPoints = 100;
constexpr int kNumBins = int(2 * kEdgeRange / kEdgeStep) + 1;

// Pixels on both sides of a peak where offsets have to be less frequent.
constexpr int kBesideBegin = int(1.25f / kEdgeStep);
constexpr int kBesideEnd = int(2 / kEdgeStep);
// Share of the greatest prominence: there may be two outlines.
constexpr float kClearHeight = 0.75f;

std::vector<float> WithinAPixel(const std::vector<float>& offsets,
                                float center) {
  std::vector<float> near;
  for (const float offset : offsets) {
    if (std::abs(offset - center) < 1) {
      near.push_back(offset);
    }
  }
  return near;
}

using Histogram = std::array<int, kNumBins>;

float MeanOf(const Histogram& counts, int begin, int end) {
  begin = std::max(begin, 0);
  end = std::min(end, kNumBins);
  return begin < end ? float(std::accumulate(
                           counts.begin() + begin, counts.begin() + end, 0)) /
                           float(end - begin)
                     : 0;
}

// The highest peak of the histogram of the offsets, to a step. Only values
// that are clearly more frequent than those on both sides count as a peak:
// where edges lie at random, the nearest ones are frequent near the border of
// the mask, but values beside are hardly less so.
float Peak(const std::vector<float>& offsets) {
  Histogram counts{};
  for (const float offset : offsets) {
    ++counts[std::clamp(
        int(std::lround((offset + kEdgeRange) / kEdgeStep)), 0, kNumBins - 1)];
  }
  std::array<float, kNumBins> means{};
  std::array<float, kNumBins> heights{};
  for (int i = 2; i + 2 < kNumBins; ++i) {
    means[i] = float(counts[i - 2] + 2 * counts[i - 1] + 3 * counts[i] +
                     2 * counts[i + 1] + counts[i + 2]) /
               9;
    heights[i] = means[i] -
                 std::max(MeanOf(counts, i - kBesideEnd, i - kBesideBegin + 1),
                          MeanOf(counts, i + kBesideBegin, i + kBesideEnd + 1));
  }
  const float clear =
      kClearHeight * *std::max_element(heights.begin(), heights.end());
  int best = 0;
  for (int i = 0; i < kNumBins; ++i) {
    if (heights[i] >= clear && means[i] > means[best]) {
      best = i;
    }
  }
  return float(best) * kEdgeStep - kEdgeRange;
}

}  // namespace

std::optional<OffsetPeak> FindOffsetPeak(const std::vector<float>& offsets,
                                         double min_share) {
  if (offsets.size() < kMinPoints) {
    return std::nullopt;
  }
  float center = Peak(offsets);
  std::vector<float> near;
  for (int i = 0; i < 3; ++i) {
    near = WithinAPixel(offsets, center);
    if (near.size() < kMinPoints ||
        double(near.size()) < min_share * double(offsets.size())) {
      return std::nullopt;
    }
    center = Median(near);
  }
  OffsetPeak peak{.center = center,
                  .share = double(near.size()) / double(offsets.size())};
  for (float& offset : near) {
    offset = std::abs(offset - center);
  }
  peak.deviation = Median(std::move(near));
  return peak;
}

}  // namespace octacut
