#include "core/texture/image_scores.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

namespace octacut {
namespace {

TEST(ImageScores, AreThoseOfKnownDifferences) {
  const cv::Mat image(40, 40, CV_8UC3, cv::Scalar(100, 100, 100));
  cv::Mat other = image + cv::Scalar(10, 10, 10);
  cv::Mat region(40, 40, CV_8UC1, cv::Scalar(0));
  region(cv::Rect(5, 5, 30, 30)).setTo(255);
  other.at<cv::Vec3b>(0, 0) = {0, 0, 0};  // out of the region
  ImageScores scores;
  AddScores(other, image, region, &scores);
  EXPECT_EQ(scores.num_pixels, 900u);
  EXPECT_EQ(scores.num_windows, 400u);
  EXPECT_NEAR(scores.Psnr(), 20 * std::log10(255.0 / 10), 1e-9);
  // Without structure, the means alone count.
  const double c1 = 2.55 * 2.55;
  EXPECT_NEAR(
      scores.Ssim(), (2 * 100 * 110 + c1) / (100 * 100 + 110 * 110 + c1), 1e-9);
}

TEST(ImageScores, AreBestForEqualImages) {
  cv::Mat image(40, 40, CV_8UC3);
  cv::randu(image, 0, 255);
  const cv::Mat region(40, 40, CV_8UC1, cv::Scalar(255));
  ImageScores scores;
  AddScores(image, image, region, &scores);
  EXPECT_TRUE(std::isinf(scores.Psnr()));
  EXPECT_NEAR(scores.Ssim(), 1, 1e-9);
}

TEST(ImageScores, EstimateTheNoiseOfAGradient) {
  cv::Mat image(200, 200, CV_16SC3);
  cv::RNG random(3);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      for (int c = 0; c < 3; ++c) {
        image.at<cv::Vec3s>(y, x)[c] =
            cv::saturate_cast<short>(60 + x / 3 + y / 4 + random.gaussian(6));
      }
    }
  }
  cv::Mat bytes;
  image.convertTo(bytes, CV_8UC3);
  cv::Mat region(200, 200, CV_8UC1, cv::Scalar(255));
  region.row(100).setTo(0);
  ImageScores noise;
  AddNoise(bytes, region, &noise);
  EXPECT_EQ(noise.num_pixels, 198u * (98 + 97));
  // Rounding to bytes adds a twelfth.
  EXPECT_NEAR(noise.squared_error / double(noise.num_pixels), 36, 2);
}

}  // namespace
}  // namespace octacut
