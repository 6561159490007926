// Whether two meshes differ by more than chance, judged by the same views.
#pragma once

#include <cstdint>
#include <span>

namespace octacut {

struct BootstrapDifference {
  double mean = 0;  // of a - b over the views
  // The middle 95 % of the means of resampled views.
  double low = 0;
  double high = 0;
  // Twice the share of resamples whose mean has the other sign or is zero, at
  // most 1: two-sided.
  double p_value = 1;

  bool IsMoreThanChance() const { return low > 0 || high < 0; }
};

// Resamples the views with replacement, 10 000 times (Efron 1979, percentile
// method). `a` and `b` hold one score per view, the same views in the same
// order. The same seed gives the same result. Throws InputError for fewer than
// two views, or unequal numbers.
BootstrapDifference PairedBootstrap(std::span<const double> a,
                                    std::span<const double> b,
                                    uint64_t seed);

}  // namespace octacut
