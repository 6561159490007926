#include "core/benchmark/synthetic/degrade.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "core/base/error.h"

namespace octacut {
namespace {

cv::Mat SquareMask() {
  cv::Mat mask(100, 120, CV_8UC1, cv::Scalar(0));
  mask(cv::Rect(30, 20, 50, 60)).setTo(255);
  return mask;
}

TEST(DegradeImage, AddsNoiseOfTheGivenStrength) {
  cv::Mat image(100, 120, CV_8UC3, cv::Scalar::all(120));
  DegradeOptions options;
  options.pixel_noise = 5;
  DegradeImage(options, 1, image);
  cv::Scalar mean, deviation;
  cv::meanStdDev(image, mean, deviation);
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(mean[channel], 120, 0.3);
    EXPECT_NEAR(deviation[channel], 5, 0.2);
  }
}

TEST(DegradeImage, ExposureChangesTheWholeView) {
  DegradeOptions options;
  options.exposure_noise = 0.1;
  int num_different = 0;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    cv::Mat image(4, 4, CV_8UC3, cv::Scalar::all(120));
    DegradeImage(options, seed, image);
    cv::Scalar mean, deviation;
    cv::meanStdDev(image, mean, deviation);
    EXPECT_EQ(deviation[0], 0);
    num_different += mean[0] != 120;
  }
  EXPECT_GE(num_different, 12);
}

TEST(DegradeMask, GrowsAndShrinks) {
  DegradeOptions options;
  cv::Mat mask = SquareMask();
  options.mask_offset = 2;
  DegradeMask(options, 1, mask);
  EXPECT_EQ(mask.at<uint8_t>(50, 28), 255);
  EXPECT_EQ(mask.at<uint8_t>(50, 27), 0);
  mask = SquareMask();
  options.mask_offset = -2;
  DegradeMask(options, 1, mask);
  EXPECT_EQ(mask.at<uint8_t>(50, 32), 255);
  EXPECT_EQ(mask.at<uint8_t>(50, 31), 0);
}

TEST(DegradeMask, CutsHolesIntoTheObjectOnly) {
  DegradeOptions options;
  options.num_mask_holes = 3;
  options.mask_defect_radius = 2.5;
  cv::Mat mask = SquareMask();
  DegradeMask(options, 1, mask);
  cv::Mat lost = SquareMask() - mask;
  EXPECT_GT(cv::countNonZero(lost), 20);
  EXPECT_LE(cv::countNonZero(lost), 3 * 25);
  EXPECT_EQ(cv::countNonZero(mask - SquareMask()), 0);
}

TEST(DegradeMask, SprinklesSpecksOverTheBackgroundOnly) {
  DegradeOptions options;
  options.num_mask_specks = 4;
  options.mask_defect_radius = 2;
  cv::Mat mask = SquareMask();
  DegradeMask(options, 1, mask);
  EXPECT_GT(cv::countNonZero(mask - SquareMask()), 9);
  EXPECT_EQ(cv::countNonZero(SquareMask() - mask), 0);
}

TEST(DegradePose, MovesTheImageByTheGivenPixels) {
  const PinholeCamera camera{640, 480, 700, 700, 320, 240};
  Rigid3d pose;
  pose.translation = {0, 0, 4};
  DegradeOptions options;
  options.pose_noise = 1.5;
  double squares = 0;
  constexpr int kCount = 2000;
  for (int seed = 0; seed < kCount; ++seed) {
    const Rigid3d noisy = DegradePose(options, seed, camera, pose);
    EXPECT_NEAR(noisy.rotation.determinant(), 1, 1e-9);
    const Eigen::Vector2d moved =
        camera.Project(noisy * Eigen::Vector3d::Zero()) -
        camera.Project(pose * Eigen::Vector3d::Zero());
    squares += moved.squaredNorm() / 2;
  }
  EXPECT_NEAR(std::sqrt(squares / kCount), 1.5, 0.1);
}

TEST(DegradeOptions, DoesNothingByDefault) {
  const DegradeOptions options;
  cv::Mat image(8, 8, CV_8UC3, cv::Scalar(1, 2, 3));
  const cv::Mat before = image.clone();
  DegradeImage(options, 1, image);
  EXPECT_EQ(cv::norm(image, before), 0);
  cv::Mat mask = SquareMask();
  DegradeMask(options, 1, mask);
  EXPECT_EQ(cv::norm(mask, SquareMask()), 0);
}

TEST(DegradeOptions, RefusesBadValues) {
  const auto refused = [](auto change) {
    DegradeOptions options;
    change(options);
    EXPECT_THROW(options.Check(), OptionError);
  };
  refused([](DegradeOptions& o) { o.pixel_noise = -1; });
  refused([](DegradeOptions& o) { o.exposure_noise = 1; });
  refused([](DegradeOptions& o) { o.mask_offset = 1000; });
  refused([](DegradeOptions& o) { o.num_mask_holes = -1; });
  refused([](DegradeOptions& o) { o.num_mask_specks = -1; });
  refused([](DegradeOptions& o) { o.mask_defect_radius = 0; });
  refused([](DegradeOptions& o) { o.pose_noise = -1; });
}

}  // namespace
}  // namespace octacut
