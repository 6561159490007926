#include "core/hull/mask_gaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace octacut {
namespace {

// An object of 60 x 40 pixels in a frame of 80 x 60, or so many times as large.
cv::Mat Mask(int scale = 1) {
  cv::Mat mask = cv::Mat::zeros(60 * scale, 80 * scale, CV_8UC1);
  mask(cv::Rect(10 * scale, 10 * scale, 60 * scale, 40 * scale)).setTo(255);
  return mask;
}

// A disc of 5.9 pixels rolls around it.
cv::Mat LargeMask() { return Mask(2); }

TEST(MaskGaps, AreWhatTheObjectEncloses) {
  cv::Mat mask = Mask();
  mask(cv::Rect(20, 20, 7, 9)).setTo(127);
  mask(cv::Rect(60, 15, 10, 10)).setTo(0);  // a bay
  const std::vector<MaskGap> gaps = FindMaskGaps(mask, 2);
  ASSERT_EQ(gaps.size(), 1u);
  EXPECT_EQ(gaps[0].box, cv::Rect(20, 20, 7, 9));
  EXPECT_EQ(gaps[0].num_pixels, 63u);
  EXPECT_EQ(cv::countNonZero(gaps[0].is_gap), 63);
}

TEST(MaskGaps, TouchTheFrameNowhere) {
  cv::Mat mask(60, 80, CV_8UC1, cv::Scalar(255));
  mask(cv::Rect(0, 20, 9, 9)).setTo(0);
  mask(cv::Rect(30, 51, 9, 9)).setTo(0);
  EXPECT_TRUE(FindMaskGaps(mask, 0).empty());
  mask(cv::Rect(1, 1, 9, 9)).setTo(0);
  EXPECT_EQ(FindMaskGaps(mask, 0).size(), 1u);
}

TEST(MaskGaps, AreDeeperThanTheMargin) {
  cv::Mat mask = Mask();
  mask(cv::Rect(20, 20, 20, 5)).setTo(0);  // three pixels deep
  EXPECT_EQ(FindMaskGaps(mask, 2.5).size(), 1u);
  EXPECT_TRUE(FindMaskGaps(mask, 3.0).empty());
}

TEST(MaskGaps, AreNotLargerThanATwentiethOfTheObject) {
  cv::Mat mask = Mask();
  mask(cv::Rect(20, 20, 10, 12)).setTo(0);  // 120 of 2280 pixels
  EXPECT_TRUE(FindMaskGaps(mask, 0).empty());
  mask(cv::Rect(20, 20, 10, 1)).setTo(255);
  EXPECT_EQ(FindMaskGaps(mask, 0).size(), 1u);
}

TEST(MaskGaps, AreNarrowBays) {
  cv::Mat mask = LargeMask();
  const cv::Rect bay(40, 20, 9, 15);  // five pixels deep
  mask(bay).setTo(0);
  const std::vector<MaskGap> gaps = FindMaskGaps(mask, 2.4);
  ASSERT_EQ(gaps.size(), 1u);
  EXPECT_FALSE(gaps[0].is_enclosed);
  EXPECT_EQ(gaps[0].box & bay, gaps[0].box);
  EXPECT_GT(gaps[0].num_pixels, 110u);
  EXPECT_TRUE(FindMaskGaps(mask, 2.5).empty());
}

TEST(MaskGaps, AreNoWideBays) {
  cv::Mat mask = LargeMask();
  mask(cv::Rect(40, 20, 14, 15)).setTo(0);
  for (const MaskGap& gap : FindMaskGaps(mask, 0)) {
    EXPECT_LT(gap.num_pixels, 30u);  // a corner
  }
}

TEST(MaskGaps, FillOutToWhereABayOpens) {
  cv::Mat mask = LargeMask();
  mask(cv::Rect(40, 20, 9, 15)).setTo(0);
  const std::vector<MaskGap> gaps = FindMaskGaps(mask, 2);
  ASSERT_EQ(gaps.size(), 1u);
  FillGap(gaps[0], &mask);
  EXPECT_EQ(cv::countNonZero(mask > LargeMask()), 0);
  // The disc reaches into what is open.
  EXPECT_LT(cv::countNonZero(LargeMask() > mask), 20);
}

TEST(MaskGaps, HaveAMiddleAndARingOfObject) {
  cv::Mat mask = Mask();
  mask(cv::Rect(11, 20, 9, 9)).setTo(0);  // beside the object's border
  const std::vector<MaskGap> gaps = FindMaskGaps(mask, 2);
  ASSERT_EQ(gaps.size(), 1u);
  // Depths 1 to 5: at least half of 5 are the innermost 5 x 5.
  EXPECT_EQ(gaps[0].middle.size(), 25u);
  for (const Eigen::Vector2f& pixel : gaps[0].middle) {
    EXPECT_LE((pixel - Eigen::Vector2f(15.5f, 24.5f)).cwiseAbs().maxCoeff(), 2);
  }
  ASSERT_FALSE(gaps[0].ring.empty());
  for (const Eigen::Vector2f& pixel : gaps[0].ring) {
    EXPECT_EQ(mask.at<uint8_t>(int(pixel.y()), int(pixel.x())), 255);
    const Eigen::Array2f from_gap =
        (pixel - Eigen::Vector2f(15.5f, 24.5f)).cwiseAbs().array() - 4;
    EXPECT_GE(from_gap.maxCoeff(), 1);
    EXPECT_LE(from_gap.maxCoeff(), 5);
  }
}

TEST(MaskGaps, FillWithTheirBorderPixels) {
  cv::Mat mask = Mask();
  mask(cv::Rect(29, 24, 9, 9)).setTo(200);  // object in part
  mask(cv::Rect(30, 25, 7, 7)).setTo(0);
  const std::vector<MaskGap> gaps = FindMaskGaps(mask, 2);
  ASSERT_EQ(gaps.size(), 1u);
  FillGap(gaps[0], &mask);
  EXPECT_EQ(cv::norm(mask, Mask(), cv::NORM_INF), 0);
}

}  // namespace
}  // namespace octacut
