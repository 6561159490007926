#include "core/segment/label_cut.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "core/segment/labels.h"

namespace octacut {
namespace {

// 20 x 10: dark on the left of column 12, bright from there on.
cv::Mat TwoSides() {
  cv::Mat image(10, 20, CV_8UC3, cv::Scalar::all(40));
  image(cv::Rect(12, 0, 8, 10)).setTo(cv::Scalar::all(200));
  return image;
}

// Columns 0 to 4 are background and 15 to 19 object; between is open.
cv::Mat OpenMiddle() {
  cv::Mat labels(10, 20, CV_8U, cv::Scalar(kNoLabel));
  labels(cv::Rect(0, 0, 5, 10)).setTo(kSurroundingsLabel);
  labels(cv::Rect(15, 0, 5, 10)).setTo(kObjectLabel);
  return labels;
}

TEST(LabelCut, RunsAlongTheEdgeWhereColoursSayNothing) {
  cv::Mat labels = OpenMiddle();
  CutLabels(TwoSides(), cv::Mat::zeros(10, 20, CV_32F), 4, &labels);
  cv::Mat expected = cv::Mat::zeros(10, 20, CV_8U);
  expected(cv::Rect(12, 0, 8, 10)).setTo(kObjectLabel);
  EXPECT_EQ(cv::countNonZero(labels != expected), 0);
}

TEST(LabelCut, SinglePixelsFollowTheirNeighbours) {
  cv::Mat labels = OpenMiddle();
  cv::Mat log_odds = cv::Mat::zeros(10, 20, CV_32F);
  log_odds(cv::Rect(0, 0, 12, 10)).setTo(-1);
  log_odds(cv::Rect(12, 0, 8, 10)).setTo(1);
  log_odds.at<float>(5, 8) = 4;  // eight neighbours against it
  CutLabels(TwoSides(), log_odds, 4, &labels);
  EXPECT_EQ(labels.at<uint8_t>(5, 8), kSurroundingsLabel);
  // Without smoothness its own evidence counts.
  labels = OpenMiddle();
  CutLabels(TwoSides(), log_odds, 0, &labels);
  EXPECT_EQ(labels.at<uint8_t>(5, 8), kObjectLabel);
}

TEST(LabelCut, AnOpenPixelMayBeAlone) {
  cv::Mat labels(10, 20, CV_8U, cv::Scalar(kSurroundingsLabel));
  labels.at<uint8_t>(5, 8) = kNoLabel;
  cv::Mat log_odds(10, 20, CV_32F, cv::Scalar(50));
  CutLabels(TwoSides(), log_odds, 1, &labels);
  EXPECT_EQ(labels.at<uint8_t>(5, 8), kObjectLabel);
  cv::Mat one(1, 1, CV_8U, cv::Scalar(kNoLabel));
  CutLabels(cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(9)),
            cv::Mat(1, 1, CV_32F, cv::Scalar(-1)),
            1,
            &one);
  EXPECT_EQ(one.at<uint8_t>(0, 0), kSurroundingsLabel);
}

TEST(LabelCut, WhatIsDecidedStays) {
  cv::Mat labels = OpenMiddle();
  cv::Mat log_odds(10, 20, CV_32F, cv::Scalar(4));
  CutLabels(TwoSides(), log_odds, 1, &labels);
  EXPECT_EQ(labels.at<uint8_t>(3, 4), kSurroundingsLabel);
  EXPECT_EQ(labels.at<uint8_t>(3, 5), kObjectLabel);
}

}  // namespace
}  // namespace octacut
