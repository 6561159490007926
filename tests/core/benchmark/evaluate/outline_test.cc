#include "core/benchmark/evaluate/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/core.hpp>
#include <random>

namespace octacut {
namespace {

// Coverage by a disc, from 16 x 16 samples per pixel.
cv::Mat Disc(int size, const Eigen::Vector2d& center, double radius) {
  constexpr int kSide = 16;
  cv::Mat coverage(size, size, CV_8UC1);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      int inside = 0;
      for (int k = 0; k < kSide * kSide; ++k) {
        const Eigen::Vector2d p(x + (k % kSide + 0.5) / kSide,
                                y + (k / kSide + 0.5) / kSide);
        inside += (p - center).norm() < radius;
      }
      coverage.at<uint8_t>(y, x) =
          uint8_t(std::lround(255.0 * inside / (kSide * kSide)));
    }
  }
  return coverage;
}

TEST(Outline, OfADiscIsItsCircle) {
  const Eigen::Vector2d center(20.3, 18.8);
  const Outline outline(Disc(40, center, 11));
  double length = 0;
  for (const OutlineSegment& segment : outline.Segments()) {
    EXPECT_NEAR((segment.begin - center).norm(), 11, 0.15);
    length += (segment.end - segment.begin).norm();
  }
  EXPECT_NEAR(length, 22 * std::numbers::pi, 0.5);
  EXPECT_NEAR(outline.Distance(center), 11, 0.15);
  EXPECT_NEAR(outline.Distance(center + Eigen::Vector2d(5, 0)), 6, 0.15);
  EXPECT_NEAR(outline.Distance(center - Eigen::Vector2d(0, 16)), 5, 0.15);
}

TEST(Outline, DistancesAreThoseOfAllSegments) {
  std::mt19937 random(3);
  cv::Mat coverage = cv::Mat::zeros(50, 70, CV_8UC1);
  for (int i = 0; i < 60; ++i) {  // loose pixels, corner to corner at times
    coverage.at<uint8_t>(random() % 15, random() % 70) = uint8_t(random());
  }
  const Outline outline(coverage);
  ASSERT_GT(outline.Segments().size(), 50u);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector2d point(random() % 7000 / 100.0,
                                random() % 5000 / 100.0);
    double nearest = std::numeric_limits<double>::infinity();
    for (const OutlineSegment& segment : outline.Segments()) {
      for (int k = 0; k <= 200; ++k) {
        const Eigen::Vector2d on =
            segment.begin + k / 200.0 * (segment.end - segment.begin);
        nearest = std::min(nearest, (on - point).norm());
      }
    }
    EXPECT_NEAR(outline.Distance(point), nearest, 0.01);
  }
}

TEST(Outline, OfTwoPixelsThatTouchAtACornerIsClosed) {
  cv::Mat coverage = cv::Mat::zeros(6, 6, CV_8UC1);
  coverage.at<uint8_t>(2, 2) = 255;
  coverage.at<uint8_t>(3, 3) = 255;
  const Outline outline(coverage);
  // Every end is the end of just two segments.
  for (const OutlineSegment& segment : outline.Segments()) {
    for (const Eigen::Vector2d& end : {segment.begin, segment.end}) {
      int count = 0;
      for (const OutlineSegment& other : outline.Segments()) {
        count += other.begin == end;
        count += other.end == end;
      }
      EXPECT_EQ(count, 2);
    }
  }
  EXPECT_EQ(outline.Segments().size(), 8u);
}

TEST(Outline, NeitherOfAnEmptyFrameNorOfItsBorder) {
  for (const int value : {0, 255}) {
    const Outline outline(cv::Mat(20, 30, CV_8UC1, cv::Scalar(value)));
    EXPECT_TRUE(outline.Segments().empty());
    EXPECT_TRUE(std::isinf(outline.Distance({3, 3})));
  }
}

}  // namespace
}  // namespace octacut
