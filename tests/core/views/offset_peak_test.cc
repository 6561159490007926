#include "core/views/offset_peak.h"

#include <gtest/gtest.h>

#include <random>

namespace octacut {
namespace {

// `count` values about `center`, and as many anywhere within six pixels.
std::vector<float> Offsets(size_t count, float center, float deviation) {
  std::mt19937 random(1);
  std::normal_distribution<float> normal(center, deviation);
  std::uniform_real_distribution<float> uniform(-6, 6);
  std::vector<float> offsets;
  for (size_t i = 0; i < count; ++i) {
    offsets.push_back(normal(random));
    offsets.push_back(uniform(random));
  }
  return offsets;
}

TEST(FindOffsetPeak, LiesAmongThoseThatAgree) {
  const auto peak = FindOffsetPeak(Offsets(1000, 1.4f, 0.2f), 0.4);
  ASSERT_TRUE(peak);
  EXPECT_NEAR(peak->center, 1.4, 0.03);
  // Half of the offsets, and a sixth of the other half. Median distances of
  // normal deviates are 0.67 deviations.
  EXPECT_NEAR(peak->share, 0.5 + 0.5 / 6, 0.03);
  EXPECT_NEAR(peak->deviation, 0.67 * 0.2, 0.05);
}

TEST(FindOffsetPeak, PrefersANarrowPeakToAHump) {
  std::vector<float> offsets = Offsets(800, 3, 0.2f);
  // Three times as many, but hardly less frequent on both sides.
  const std::vector<float> hump = Offsets(2400, 0, 2);
  offsets.insert(offsets.end(), hump.begin(), hump.end());
  const auto peak = FindOffsetPeak(offsets, 0);
  ASSERT_TRUE(peak);
  EXPECT_NEAR(peak->center, 3, 0.1);
}

TEST(FindOffsetPeak, IsNoneForFewOffsetsOrASmallShare) {
  EXPECT_FALSE(FindOffsetPeak({}, 0));
  EXPECT_FALSE(FindOffsetPeak(Offsets(40, 1, 0.1f), 0));
  EXPECT_FALSE(FindOffsetPeak(Offsets(1000, 1, 0.2f), 0.7));
}

}  // namespace
}  // namespace octacut
