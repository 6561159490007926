#include "core/segment/other_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

namespace octacut {
namespace {

// The consensus of other views whose log odds are `log_odds`.
cv::Mat ConsensusFor(float log_odds) {
  return cv::Mat(
      1, 1, CV_32F, cv::Scalar(std::tanh(log_odds / kMaxViewLogOdds)));
}

TEST(EvidenceOfOthers, CountsLessForTheObjectThanAgainstIt) {
  const cv::Mat others = (cv::Mat_<float>(1, 3) << -1, 0, 1);
  const cv::Mat evidence = EvidenceOfOthers(others);
  EXPECT_EQ(evidence.at<float>(0), -4);
  EXPECT_EQ(evidence.at<float>(1), 0);
  EXPECT_EQ(evidence.at<float>(2), 2);
}

TEST(ExcludedByOthers, NeedsNearlyTwoViewsThatAreSure) {
  EXPECT_EQ(ExcludedByOthers(ConsensusFor(-2 * kMaxViewLogOdds)).at<uint8_t>(0),
            255);
  EXPECT_EQ(ExcludedByOthers(ConsensusFor(-kMaxViewLogOdds)).at<uint8_t>(0), 0);
}

TEST(ShownByOthers, NeedsHalfOfWhatSureViewsSay) {
  for (const size_t num_others : {5, 15, 35}) {
    const float sure = OccupancyGrid::LogOddsOfSure(num_others);
    EXPECT_EQ(
        ShownByOthers(ConsensusFor(0.52f * sure), num_others).at<uint8_t>(0),
        255);
    EXPECT_EQ(
        ShownByOthers(ConsensusFor(0.48f * sure), num_others).at<uint8_t>(0),
        0);
  }
}

TEST(ShownByOthers, IsEnoughWhereTwoCouldDenyIt) {
  const size_t num_others = 200;
  EXPECT_EQ(ShownByOthers(ConsensusFor(2.1f * kMaxViewLogOdds), num_others)
                .at<uint8_t>(0),
            255);
  EXPECT_EQ(ShownByOthers(ConsensusFor(1.9f * kMaxViewLogOdds), num_others)
                .at<uint8_t>(0),
            0);
}

}  // namespace
}  // namespace octacut
