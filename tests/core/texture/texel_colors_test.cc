#include "core/texture/texel_colors.h"

#include <gtest/gtest.h>

#include <random>

namespace octacut {
namespace {

using Color = Eigen::Vector3f;

// Pages on which the chosen view and four others show grey 100 with noise.
TEST(TexelColors, AveragesNoiseOfViewsAndEstimatesIt) {
  constexpr int kSide = 64;
  constexpr float kNoise = 6;
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0, kNoise);
  const auto grey = [&] {
    return Color(100 + noise(random), 100 + noise(random), 100 + noise(random));
  };
  TexelColors colors({kSide, kSide});
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      colors.Add(x, y, grey(), 1);
      for (int i = 0; i < 4; ++i) {
        colors.AddSample(x, y, grey(), 0.49f);
      }
    }
  }
  // The median deviation of four samples from their own median is too small by
  // about a fifth.
  EXPECT_NEAR(colors.Noise(), kNoise, 0.3 * kNoise);
  double sum = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      cv::Vec3b pixel;
      ASSERT_TRUE(colors.Mean(x, y, kNoise, &pixel));
      sum += std::pow(pixel[0] - 100.0, 2);
    }
  }
  // Five views of the same weight have 0.45 of the deviation of one.
  EXPECT_NEAR(std::sqrt(sum / (kSide * kSide)), 0.45 * kNoise, 0.05 * kNoise);
}

TEST(TexelColors, LeavesOtherColorsOut) {
  TexelColors colors({1, 1});
  colors.Add(0, 0, Color(60, 70, 80), 1);
  // An edge that is elsewhere in these views.
  for (int i = 0; i < 6; ++i) {
    colors.AddSample(0, 0, Color(160, 170, 180), 0.49f);
  }
  cv::Vec3b pixel;
  ASSERT_TRUE(colors.Mean(0, 0, 6, &pixel));
  EXPECT_EQ(pixel, cv::Vec3b(60, 70, 80));
}

}  // namespace
}  // namespace octacut
