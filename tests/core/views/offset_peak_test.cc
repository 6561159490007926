#include "core/views/offset_peak.h"

#include <gtest/gtest.h>

#include <cmath>
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

TEST(FindOffsetPeak, PrefersANarrowPeakToAHigherHump) {
  std::vector<float> offsets(150, 4.5f);
  for (int k = -24; k <= 24; ++k) {
    const float at = 0.25f * float(k);
    offsets.insert(offsets.end(), size_t(100 * (1 - std::abs(at) / 8)), at);
  }
  const auto peak = FindOffsetPeak(offsets, 0);
  ASSERT_TRUE(peak);
  // The hump below it draws the median inward.
  EXPECT_NEAR(peak->center, 4.5, 0.3);
}

TEST(FindOffsetPeak, IsNoneForFewOffsetsOrASmallShare) {
  EXPECT_FALSE(FindOffsetPeak({}, 0));
  EXPECT_FALSE(FindOffsetPeak(Offsets(40, 1, 0.1f), 0));
  // Enough, but fewer than a hundred of them at the peak.
  EXPECT_FALSE(FindOffsetPeak(Offsets(60, 1, 0.1f), 0));
  EXPECT_FALSE(FindOffsetPeak(Offsets(1000, 1, 0.2f), 0.7));
}

TEST(FindLonePeak, LiesWhereMostAgreeWhateverTheBorder) {
  std::vector<float> offsets = Offsets(1000, 11.3f, 0.3f);
  const auto peak = FindLonePeak(offsets, 16);
  ASSERT_TRUE(peak);
  EXPECT_NEAR(*peak, 11.3, 0.3);
  EXPECT_GT(PeakHeight(offsets, 16, 11, 1), 10 * PeakHeight(offsets, 16, 0, 1));
}

TEST(FindLonePeak, IsNoneForFewOffsetsNoiseOrTwoPeaks) {
  EXPECT_FALSE(FindLonePeak(Offsets(40, 9, 0.3f), 16));
  EXPECT_FALSE(FindLonePeak(Offsets(2000, 0, 20), 6));
  std::vector<float> two = Offsets(1000, 9, 0.3f);
  for (const float offset : Offsets(800, -1, 0.3f)) {
    two.push_back(offset);
  }
  EXPECT_FALSE(FindLonePeak(two, 16));
}

}  // namespace
}  // namespace octacut
