#include "core/hull/mask_holes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace octacut {
namespace {

// An object of 60 x 40 pixels in a frame of 80 x 60.
cv::Mat Mask() {
  cv::Mat mask = cv::Mat::zeros(60, 80, CV_8UC1);
  mask(cv::Rect(10, 10, 60, 40)).setTo(255);
  return mask;
}

TEST(MaskHoles, AreWhatTheObjectEncloses) {
  cv::Mat mask = Mask();
  mask(cv::Rect(20, 20, 7, 9)).setTo(127);
  mask(cv::Rect(60, 15, 10, 10)).setTo(0);  // a bay
  const std::vector<MaskHole> holes = FindMaskHoles(mask, 2, 1);
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_EQ(holes[0].box, cv::Rect(20, 20, 7, 9));
  EXPECT_EQ(holes[0].num_pixels, 63u);
  EXPECT_EQ(cv::countNonZero(holes[0].is_hole), 63);
}

TEST(MaskHoles, TouchTheFrameNowhere) {
  cv::Mat mask(60, 80, CV_8UC1, cv::Scalar(255));
  mask(cv::Rect(0, 20, 9, 9)).setTo(0);
  mask(cv::Rect(30, 51, 9, 9)).setTo(0);
  EXPECT_TRUE(FindMaskHoles(mask, 0, 1).empty());
  mask(cv::Rect(1, 1, 9, 9)).setTo(0);
  EXPECT_EQ(FindMaskHoles(mask, 0, 1).size(), 1u);
}

TEST(MaskHoles, AreDeeperThanTheMargin) {
  cv::Mat mask = Mask();
  mask(cv::Rect(20, 20, 30, 5)).setTo(0);  // three pixels deep
  EXPECT_EQ(FindMaskHoles(mask, 2.5, 1).size(), 1u);
  EXPECT_TRUE(FindMaskHoles(mask, 3.0, 1).empty());
}

TEST(MaskHoles, AreNotLargerThanTheShareOfTheObject) {
  cv::Mat mask = Mask();
  mask(cv::Rect(20, 20, 10, 20)).setTo(0);  // 200 of 2200 pixels
  EXPECT_TRUE(FindMaskHoles(mask, 0, 0.09).empty());
  EXPECT_EQ(FindMaskHoles(mask, 0, 0.092).size(), 1u);
}

TEST(MaskHoles, HaveAMiddleAndARingOfObject) {
  cv::Mat mask = Mask();
  mask(cv::Rect(11, 20, 9, 9)).setTo(0);  // beside the object's border
  const std::vector<MaskHole> holes = FindMaskHoles(mask, 2, 1);
  ASSERT_EQ(holes.size(), 1u);
  // Depths 1 to 5: at least half of 5 are the innermost 5 x 5.
  EXPECT_EQ(holes[0].middle.size(), 25u);
  for (const Eigen::Vector2f& pixel : holes[0].middle) {
    EXPECT_LE((pixel - Eigen::Vector2f(15.5f, 24.5f)).cwiseAbs().maxCoeff(), 2);
  }
  ASSERT_FALSE(holes[0].ring.empty());
  for (const Eigen::Vector2f& pixel : holes[0].ring) {
    EXPECT_EQ(mask.at<uint8_t>(int(pixel.y()), int(pixel.x())), 255);
    const Eigen::Array2f from_hole =
        (pixel - Eigen::Vector2f(15.5f, 24.5f)).cwiseAbs().array() - 4;
    EXPECT_GE(from_hole.maxCoeff(), 1);
    EXPECT_LE(from_hole.maxCoeff(), 5);
  }
}

TEST(MaskHoles, FillWithTheirBorderPixels) {
  cv::Mat mask = Mask();
  mask(cv::Rect(29, 24, 9, 9)).setTo(200);  // object in part
  mask(cv::Rect(30, 25, 7, 7)).setTo(0);
  const std::vector<MaskHole> holes = FindMaskHoles(mask, 2, 1);
  ASSERT_EQ(holes.size(), 1u);
  FillHole(holes[0], &mask);
  EXPECT_EQ(cv::norm(mask, Mask(), cv::NORM_INF), 0);
}

}  // namespace
}  // namespace octacut
