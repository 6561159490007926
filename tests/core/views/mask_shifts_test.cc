#include "core/views/mask_shifts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "core/views/coarse_shift.h"
#include "tests/core/views/disc_views.h"

namespace octacut {
namespace {

using testing::DiscCoverage;
using testing::kDiscImageSize;
using testing::kDiscRadius;
using testing::MakeDiscView;

// Masks that are larger by these pixels.
ViewSet DiscViews(const std::vector<double>& shifts) {
  ViewSet views;
  for (const double shift : shifts) {
    views.push_back(MakeDiscView(shift, 0.6, 0.1));
  }
  return views;
}

TEST(FindMaskShifts, FindsTheMasksThatAreOff) {
  const auto shifts =
      FindMaskShifts(DiscViews({0.3, 7, 0.3, 0, 0.5, -4, 0, 0.3}), Context(2));
  ASSERT_EQ(shifts.size(), 2u);
  EXPECT_EQ(shifts[0].view, 1u);
  EXPECT_NEAR(shifts[0].pixels, 6.7, 0.4);
  EXPECT_EQ(shifts[1].view, 5u);
  EXPECT_NEAR(shifts[1].pixels, -4.3, 0.4);
}

TEST(FindMaskShifts, LeavesWhatMostMasksHaveInCommon) {
  EXPECT_TRUE(FindMaskShifts(DiscViews({5, 5, 6, 5, 5}), Context(1)).empty());
  const auto shifts = FindMaskShifts(DiscViews({5, 5, 0, 5, 5}), Context(1));
  ASSERT_EQ(shifts.size(), 1u);
  EXPECT_EQ(shifts[0].view, 2u);
  EXPECT_NEAR(shifts[0].pixels, -5, 0.4);
}

TEST(FindMaskShifts, AsksThePhotographsAloneWhereMasksDisagree) {
  const auto shifts =
      FindMaskShifts(DiscViews({5, 0, 5, 0, -5, 5, -5}), Context(1));
  ASSERT_EQ(shifts.size(), 5u);
  for (const MaskShift& shift : shifts) {
    EXPECT_NEAR(std::abs(shift.pixels), 5, 0.4);
  }
}

TEST(FindMaskShifts, FindsNothingWithoutEdges) {
  ViewSet views = {MakeDiscView(5, 0.2, 0.2), MakeDiscView(0, 0.2, 0.2)};
  EXPECT_TRUE(FindMaskShifts(views, Context(1)).empty());
  views = DiscViews({0, 8});
  for (PreparedView& view : views) {
    view.pyramid = ImagePyramid();
  }
  EXPECT_TRUE(FindMaskShifts(views, Context(1)).empty());
  EXPECT_TRUE(FindMaskShifts({}, Context(1)).empty());
}

TEST(MoveBorderInside, GrowsAndShrinksADisc) {
  const PreparedView view = MakeDiscView(0, 0.6, 0.1);
  for (const double pixels : {-6.5, -0.5, 0.0, 3.0}) {
    const cv::Mat mask = MoveBorderInside(
        view.silhouette, {kDiscImageSize, kDiscImageSize}, pixels);
    double area = 0;
    double truth = 0;
    for (int y = 0; y < kDiscImageSize; ++y) {
      for (int x = 0; x < kDiscImageSize; ++x) {
        area += mask.at<uint8_t>(y, x) / 255.0;
        truth += DiscCoverage(x, y, kDiscRadius - pixels);
      }
    }
    // What distances are known to, all around.
    EXPECT_NEAR(area, truth, 0.3 * 2 * CV_PI * (kDiscRadius - pixels));
  }
}

TEST(FindCoarseShift, IsDoubtedWhereFaintEdgesAreAtTheBorder) {
  EdgePositions edges;
  edges.num_lines = 400;
  for (int i = 0; i < 400; ++i) {
    const float noise = 0.4f * std::sin(float(i));
    edges.comparable.push_back(8 + noise);
    edges.all.push_back(8 + noise);
    edges.all.push_back(noise);
  }
  const CoarseShift doubted = FindCoarseShift(edges);
  EXPECT_TRUE(doubted.is_doubted);
  EXPECT_FALSE(doubted.shift);
  edges.all = edges.comparable;
  const CoarseShift known = FindCoarseShift(edges);
  ASSERT_TRUE(known.shift);
  EXPECT_FALSE(known.is_doubted);
  EXPECT_NEAR(*known.shift, 8, 0.5);
}

// As in photographs that are burnt out in part.
TEST(FindCoarseShift, IsNoneWhereFewLinesHaveAnEdge) {
  EdgePositions edges;
  edges.num_lines = 3000;
  for (int i = 0; i < 400; ++i) {
    edges.comparable.push_back(8 + 0.4f * std::sin(float(i)));
  }
  EXPECT_FALSE(FindCoarseShift(edges).shift);
  edges.num_lines = 1500;
  EXPECT_TRUE(FindCoarseShift(edges).shift);
}

}  // namespace
}  // namespace octacut
