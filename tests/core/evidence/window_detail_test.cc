#include "core/evidence/window_detail.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <random>

namespace octacut {
namespace {

constexpr int kDetailSize = 40;
constexpr int kDetailRadius = 2;
constexpr float kLeastDeviation = 2;

cv::Mat1f ImageOf(const auto& grey_of) {
  cv::Mat1f image(kDetailSize, kDetailSize);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      image(y, x) = float(grey_of(x, y));
    }
  }
  return image;
}

double MeanShare(const cv::Mat1f& image) {
  // Windows at the border see the image mirrored.
  constexpr int kBorder = 8;
  const cv::Rect inner(
      kBorder, kBorder, kDetailSize - 2 * kBorder, kDetailSize - 2 * kBorder);
  return cv::mean(
      ShareWithDetail(image, kDetailRadius, kLeastDeviation)(inner))[0];
}

TEST(ShareWithDetail, ShadingHasNoneAndTextureHas) {
  EXPECT_EQ(MeanShare(ImageOf([](int, int) { return 120; })), 0);
  EXPECT_EQ(MeanShare(ImageOf([](int x, int y) { return 5 * x - 3 * y; })), 0);
  EXPECT_EQ(MeanShare(ImageOf([](int x, int y) {
              return 5 * x + ((x / 2 + y / 2) % 2 == 0 ? 20 : 0);
            })),
            1);
}

TEST(ShareWithDetail, TellsNoiseOfTheLeastDeviationFromLess) {
  std::mt19937 random(3);
  const auto noise = [&](float deviation) {
    std::normal_distribution<float> normal(100, deviation);
    return ImageOf([&](int, int) { return normal(random); });
  };
  EXPECT_LT(MeanShare(noise(0.5f * kLeastDeviation)), 0.01);
  EXPECT_GT(MeanShare(noise(2 * kLeastDeviation)), 0.99);
}

TEST(ShareWithDetail, IsThatOfTheWindowsAround) {
  const cv::Mat1f share = ShareWithDetail(
      ImageOf([](int x, int y) { return x < 20 ? 0 : (x + y) % 2 * 20; }),
      kDetailRadius,
      kLeastDeviation);
  EXPECT_EQ(share(20, 4), 0);
  EXPECT_EQ(share(20, 35), 1);
  // Windows that reach over the edge have detail.
  EXPECT_NEAR(share(20, 18), 5.0 / 9, 0.12);
}

}  // namespace
}  // namespace octacut
