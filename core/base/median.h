// The median of values in any order, and how far from it they lie.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace octacut {

// The upper one of an even number of values, of which there is at least one.
template <typename T>
T Median(std::vector<T> values) {
  const auto middle =
      values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The standard deviation of a normal distribution over the median distance from
// its median.
inline constexpr double kDeviationOfMedian = 1.4826;

template <typename T>
struct MedianSpread {
  T median = 0;
  // The standard deviation if most values are normally distributed: few others
  // hardly change it.
  T deviation = 0;
};

// Of at least one value.
template <typename T>
MedianSpread<T> SpreadAroundMedian(std::vector<T> values) {
  MedianSpread<T> spread{.median = Median(values)};
  for (T& value : values) {
    value = std::abs(value - spread.median);
  }
  spread.deviation = T(kDeviationOfMedian) * Median(std::move(values));
  return spread;
}

}  // namespace octacut
