#include "core/texture/fill_gaps.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace octacut {
namespace {

TEST(FillGaps, KeepsWhatIsKnownAndContinuesIt) {
  cv::Mat image(37, 53, CV_8UC3, cv::Scalar(0, 0, 0));
  cv::Mat known(37, 53, CV_8UC1, cv::Scalar(0));
  image.colRange(0, 4).setTo(cv::Scalar(10, 20, 30));
  image.colRange(49, 53).setTo(cv::Scalar(200, 210, 220));
  known.colRange(0, 4).setTo(255);
  known.colRange(49, 53).setTo(255);
  FillGaps(known, &image);
  EXPECT_EQ(image.at<cv::Vec3b>(5, 2), cv::Vec3b(10, 20, 30));
  EXPECT_EQ(image.at<cv::Vec3b>(36, 52), cv::Vec3b(200, 210, 220));
  // Beside the known part it goes on; nothing stays black.
  EXPECT_EQ(image.at<cv::Vec3b>(20, 5), cv::Vec3b(10, 20, 30));
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      EXPECT_GE(image.at<cv::Vec3b>(y, x)[0], 10);
      EXPECT_LE(image.at<cv::Vec3b>(y, x)[2], 220);
    }
  }
}

}  // namespace
}  // namespace octacut
