#include "core/benchmark/synthetic/move_mask_border.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace octacut {
namespace {

cv::Mat DiscMask(int radius) {
  cv::Mat mask(80, 100, CV_8UC1);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      mask.at<uint8_t>(y, x) = std::hypot(x - 50, y - 40) <= radius ? 255 : 0;
    }
  }
  return mask;
}

// Pixels in which two masks differ by as much as object and background do.
int CountDifferences(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat difference;
  cv::absdiff(a, b, difference);
  return cv::countNonZero(difference > 127);
}

TEST(MoveMaskBorder, OfNothingLeavesTheMask) {
  const cv::Mat mask = DiscMask(20);
  EXPECT_EQ(CountDifferences(MoveMaskBorder(mask, 0), mask), 0);
}

TEST(MoveMaskBorder, MovesTheBorderBothWays) {
  const cv::Mat mask = DiscMask(20);
  for (const int pixels : {-6, -2, -1, 1, 2, 6}) {
    const cv::Mat moved = MoveMaskBorder(mask, pixels);
    const cv::Mat expected = DiscMask(20 + pixels);
    // A few pixels of the digital circle differ.
    EXPECT_LT(CountDifferences(moved, expected), 40) << pixels;
    EXPECT_GT(CountDifferences(moved, mask), 60 * std::abs(pixels)) << pixels;
  }
}

TEST(MoveMaskBorder, TheFrameIsNoBorder) {
  const cv::Mat object(40, 60, CV_8UC1, cv::Scalar(255));
  EXPECT_EQ(CountDifferences(MoveMaskBorder(object, -5), object), 0);
  const cv::Mat background = cv::Mat::zeros(40, 60, CV_8UC1);
  EXPECT_EQ(CountDifferences(MoveMaskBorder(background, 5), background), 0);
}

TEST(MoveMaskBorder, KeepsPartialCoverage) {
  cv::Mat mask = cv::Mat::zeros(20, 20, CV_8UC1);
  mask.colRange(0, 8).setTo(255);
  mask.col(8).setTo(100);
  const cv::Mat moved = MoveMaskBorder(mask, 3);
  EXPECT_EQ(moved.at<uint8_t>(10, 10), 255);
  EXPECT_EQ(moved.at<uint8_t>(10, 11), 100);
  EXPECT_EQ(moved.at<uint8_t>(10, 12), 0);
}

}  // namespace
}  // namespace octacut
