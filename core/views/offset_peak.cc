#include "core/views/offset_peak.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "core/base/median.h"
#include "core/views/border_lines.h"

namespace octacut {
namespace {

constexpr size_t kMinPoints = 100;

// Pixels on both sides of a peak where offsets have to be less frequent.
constexpr int kBesideBegin = int(1.25f / kEdgeStep);
constexpr int kBesideEnd = int(2 / kEdgeStep);
// Share of the greatest prominence: there may be two outlines.
constexpr float kClearHeight = 0.75f;
// What a lone peak rises above the values beside it, as a share of itself, and
// what another one may have of its height (docs/experiments/mask_borders.md).
constexpr float kMinRise = 1.0f / 3;
constexpr float kMaxRival = 0.5f;

float MeanOf(const std::vector<int>& counts, int begin, int end) {
  begin = std::max(begin, 0);
  end = std::min(end, int(counts.size()));
  return begin < end ? float(std::accumulate(
                           counts.begin() + begin, counts.begin() + end, 0)) /
                           float(end - begin)
                     : 0;
}

// A histogram of offsets within a range, in steps.
struct Frequencies {
  std::vector<float> means;    // smoothed counts
  std::vector<float> heights;  // by which they exceed those on both sides
};

Frequencies CountOffsets(const std::vector<float>& offsets, float range) {
  const int num_bins = int(2 * range / kEdgeStep) + 1;
  std::vector<int> counts(num_bins);
  for (const float offset : offsets) {
    ++counts[std::clamp(
        int(std::lround((offset + range) / kEdgeStep)), 0, num_bins - 1)];
  }
  Frequencies result{std::vector<float>(num_bins),
                     std::vector<float>(num_bins)};
  for (int i = 2; i + 2 < num_bins; ++i) {
    result.means[i] = float(counts[i - 2] + 2 * counts[i - 1] + 3 * counts[i] +
                            2 * counts[i + 1] + counts[i + 2]) /
                      9;
    result.heights[i] =
        result.means[i] -
        std::max(MeanOf(counts, i - kBesideEnd, i - kBesideBegin + 1),
                 MeanOf(counts, i + kBesideBegin, i + kBesideEnd + 1));
  }
  return result;
}

// The most frequent offset. Only values that are clearly more frequent than
// those on both sides count as a peak: where edges lie at random, the nearest
// ones are frequent near the border of the mask, but values beside are hardly
// less so.
size_t HighestPeak(const Frequencies& frequencies) {
  const auto& [means, heights] = frequencies;
  const float clear =
      kClearHeight * *std::max_element(heights.begin(), heights.end());
  size_t best = 0;
  for (size_t i = 0; i < means.size(); ++i) {
    if (heights[i] >= clear && means[i] > means[best]) {
      best = i;
    }
  }
  return best;
}

}  // namespace

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

std::optional<OffsetPeak> FindOffsetPeak(const std::vector<float>& offsets,
                                         double min_share) {
  if (offsets.size() < kMinPoints) {
    return std::nullopt;
  }
  std::optional<OffsetPeak> peak = OffsetPeak{
      .center =
          float(HighestPeak(CountOffsets(offsets, kEdgeRange))) * kEdgeStep -
          kEdgeRange};
  for (int i = 0; i < 3; ++i) {
    peak = PeakAround(peak->center, offsets);
    if (!peak || peak->share < min_share) {
      return std::nullopt;
    }
  }
  return peak;
}

std::optional<OffsetPeak> PeakAround(double center,
                                     const std::vector<float>& offsets) {
  std::vector<float> near = WithinAPixel(offsets, float(center));
  if (near.size() < kMinPoints) {
    return std::nullopt;
  }
  const float median = Median(near);
  OffsetPeak peak{.center = median,
                  .share = double(near.size()) / double(offsets.size())};
  for (float& offset : near) {
    offset = std::abs(offset - median);
  }
  peak.deviation = Median(std::move(near));
  return peak;
}

std::optional<float> FindLonePeak(const std::vector<float>& offsets,
                                  float range) {
  if (offsets.size() < kMinPoints) {
    return std::nullopt;
  }
  const Frequencies frequencies = CountOffsets(offsets, range);
  const auto& [means, heights] = frequencies;
  const size_t best = HighestPeak(frequencies);
  if (!(heights[best] > 0 && heights[best] >= kMinRise * means[best])) {
    return std::nullopt;
  }
  for (size_t i = 0; i < heights.size(); ++i) {
    if (std::abs(int(i) - int(best)) > kBesideEnd &&
        heights[i] > kMaxRival * heights[best]) {
      return std::nullopt;
    }
  }
  return float(best) * kEdgeStep - range;
}

float PeakHeight(const std::vector<float>& offsets,
                 float range,
                 float center,
                 float reach) {
  const std::vector<float> heights = CountOffsets(offsets, range).heights;
  float highest = 0;
  for (size_t i = 0; i < heights.size(); ++i) {
    if (std::abs(float(i) * kEdgeStep - range - center) <= reach) {
      highest = std::max(highest, heights[i]);
    }
  }
  return highest;
}

}  // namespace octacut
