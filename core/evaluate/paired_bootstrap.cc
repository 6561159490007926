#include "core/evaluate/paired_bootstrap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/base/error.h"
#include "core/base/hash.h"

namespace octacut {
namespace {

// The limits of 95 % are then known to about a tenth of their distance from
// the mean's standard error.
constexpr size_t kResamples = 10000;

}  // namespace

BootstrapDifference PairedBootstrap(std::span<const double> a,
                                    std::span<const double> b,
                                    uint64_t seed) {
  if (a.size() != b.size() || a.size() < 2) {
    throw InputError("bootstrap: at least two views with both scores needed");
  }
  const size_t count = a.size();
  std::vector<double> differences(count);
  BootstrapDifference result;
  for (size_t i = 0; i < count; ++i) {
    differences[i] = a[i] - b[i];
    result.mean += differences[i] / double(count);
  }
  std::vector<double> means(kResamples);
  for (size_t sample = 0; sample < kResamples; ++sample) {
    double sum = 0;
    for (size_t i = 0; i < count; ++i) {
      const double uniform = HashUniform(HashBits(seed, sample, i));
      sum += differences[std::min(count - 1, size_t(uniform * double(count)))];
    }
    means[sample] = sum / double(count);
  }
  std::sort(means.begin(), means.end());
  result.low = means[size_t(0.025 * kResamples)];
  result.high = means[size_t(0.975 * kResamples) - 1];
  const auto not_above =
      size_t(std::upper_bound(means.begin(), means.end(), 0.0) - means.begin());
  const auto below =
      size_t(std::lower_bound(means.begin(), means.end(), 0.0) - means.begin());
  const size_t other_sign = result.mean > 0 ? not_above : kResamples - below;
  result.p_value = std::min(1.0, 2 * double(other_sign) / double(kResamples));
  return result;
}

}  // namespace octacut
