#include "core/segment/refine_border.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/segment/labels.h"
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

// What a stroke says counts wherever it is.
TEST(RefineBorder, KeepsStrokesFarFromTheMask) {
  const cv::Size size(400, 300);
  const cv::Mat truth = Disc(size, 50);
  const cv::Rect stroke(10, 10, 20, 8);
  cv::Mat labels(size, CV_8U, cv::Scalar(kNoLabel));
  labels(stroke).setTo(kObjectLabel);
  const cv::Mat refined = RefineBorder(PictureOf(truth), truth, 6, labels);
  EXPECT_EQ(cv::countNonZero(refined(stroke)), stroke.area());
}

// A piece of the room 20 pixels wide, and a notch as deep, are four times as
// far from the border as the reach.
TEST(RefineBorder, GoesOnWhereTheBorderIsFartherAway) {
  const cv::Size size(400, 300);
  const cv::Mat truth = Disc(size, 100);
  cv::Mat mask = truth.clone();
  cv::rectangle(mask, {290, 130, 30, 40}, cv::Scalar(255), cv::FILLED);
  cv::rectangle(mask, {100, 140, 20, 20}, cv::Scalar(0), cv::FILLED);
  ASSERT_LT(Overlap(mask, truth), 0.975);
  EXPECT_GT(Overlap(RefineBorder(PictureOf(truth), mask, 5), truth), 0.998);
}

// The object has its surroundings' colour of the other half of the picture.
TEST(RefineBorder, ColoursAreThoseNearby) {
  const cv::Size size(600, 160);
  cv::Mat truth = cv::Mat::zeros(size, CV_8U);
  truth.rowRange(60, 110).colRange(30, 570).setTo(255);
  const cv::Mat picture = PictureOf(truth);
  cv::Mat image = PictureOf(~truth);
  picture.colRange(0, 300).copyTo(image.colRange(0, 300));
  cv::Mat mask = cv::Mat::zeros(size, CV_8U);
  mask.rowRange(57, 107).colRange(33, 573).setTo(255);
  ASSERT_LT(Overlap(mask, truth), 0.9);
  EXPECT_GT(Overlap(RefineBorder(image, mask, 5), truth), 0.99);
}

TEST(RefineBorder, KeepsWhatIsKnown) {
  const cv::Mat disc = Disc({200, 160}, 50);
  const cv::Rect outside(0, 110, 200, 50);
  const cv::Rect inside(90, 20, 20, 20);
  cv::Mat labels(disc.size(), CV_8U, cv::Scalar(kNoLabel));
  labels(outside).setTo(kSurroundingsLabel);
  labels(inside).setTo(kObjectLabel);
  cv::Mat truth = disc.clone();
  truth(outside).setTo(0);
  truth(inside).setTo(255);
  for (const double reach : {7.0, 20.0}) {
    const cv::Mat refined = RefineBorder(PictureOf(disc), disc, reach, labels);
    EXPECT_GT(Overlap(refined, truth), 0.99) << reach;
    EXPECT_EQ(cv::countNonZero(refined(outside)), 0);
    EXPECT_EQ(cv::countNonZero(refined(inside)), inside.area());
  }
}

TEST(RefineBorder, LeavesARightBorderAsItIs) {
  const cv::Mat truth = Disc({200, 160}, 50);
  EXPECT_GT(Overlap(RefineBorder(PictureOf(truth), truth, 7), truth), 0.998);
}

TEST(RefineBorder, AnEmptyMaskStaysEmpty) {
  const cv::Mat none = cv::Mat::zeros(60, 80, CV_8U);
  EXPECT_EQ(cv::countNonZero(RefineBorder(PictureOf(none), none, 5)), 0);
}

}  // namespace
}  // namespace octacut
