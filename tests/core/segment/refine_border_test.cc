#include "core/segment/refine_border.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/core/segment/ring_scene.h"

namespace octacut {
namespace {

using testing::kBallColour;
using testing::kRoomColour;
using testing::Overlap;
using testing::Paint;

cv::Mat Disc(const cv::Size& size, double radius) {
  cv::Mat disc = cv::Mat::zeros(size, CV_8U);
  cv::circle(disc,
             {size.width / 2, size.height / 2},
             int(radius),
             cv::Scalar(255),
             cv::FILLED);
  return disc;
}

cv::Mat PictureOf(const cv::Mat& mask) {
  cv::Mat image(mask.size(), CV_8UC3);
  Paint(~mask, kRoomColour, 1, &image);
  Paint(mask, kBallColour, 2, &image);
  return image;
}

TEST(RefineBorder, FindsTheBorderToThePixel) {
  const cv::Mat truth = Disc({200, 160}, 50);
  for (const double radius : {45.0, 55.0}) {
    const cv::Mat refined =
        RefineBorder(PictureOf(truth), Disc({200, 160}, radius), 7);
    EXPECT_GT(Overlap(refined, truth), 0.998) << radius;
  }
}

TEST(RefineBorder, WorksOffLargeReachesFromCoarseToFine) {
  const cv::Mat truth = Disc({800, 600}, 200);
  const cv::Mat refined =
      RefineBorder(PictureOf(truth), Disc({800, 600}, 180), 25);
  EXPECT_GT(Overlap(refined, truth), 0.998);
}

TEST(RefineBorder, MovesNoFartherThanItsReach) {
  const cv::Mat truth = Disc({200, 160}, 50);
  const cv::Mat mask = Disc({200, 160}, 30);
  const cv::Mat refined = RefineBorder(PictureOf(truth), mask, 5);
  cv::Mat far;
  cv::distanceTransform(~mask, far, cv::DIST_L2, cv::DIST_MASK_5);
  EXPECT_EQ(cv::countNonZero(refined & (far > 5)), 0);
}

TEST(RefineBorder, AnEmptyMaskStaysEmpty) {
  const cv::Mat none = cv::Mat::zeros(60, 80, CV_8U);
  EXPECT_EQ(cv::countNonZero(RefineBorder(PictureOf(none), none, 5)), 0);
}

}  // namespace
}  // namespace octacut
