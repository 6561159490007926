#include "core/hull/false_gaps.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "core/hull/mask_gaps.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::MakeTestScene;
using testing::TestScene;

constexpr double kTolerance = 2;

RepairedScene Fill(const TestScene& test, int num_threads = 2) {
  return FillFalseGaps(
      test.scene, test.region.cube, kTolerance, Context(num_threads));
}

// Where the view shows the middle of its object's mask.
cv::Point Middle(const View& view) {
  const cv::Moments moments = cv::moments(view.mask, true);
  return {int(moments.m10 / moments.m00), int(moments.m01 / moments.m00)};
}

void Punch(const cv::Point& at, int radius, View* view) {
  view->mask = view->mask.clone();
  cv::circle(view->mask, at, radius, cv::Scalar(0), cv::FILLED);
}

double Difference(const View& a, const View& b) {
  return cv::norm(a.mask, b.mask, cv::NORM_INF);
}

TEST(FalseGaps, AreFilledAndNothingElse) {
  const TestScene exact = MakeTestScene("sphere");
  TestScene test = exact;
  Punch(Middle(test.scene.views[2]), 5, &test.scene.views[2]);
  Punch(Middle(test.scene.views[9]) + cv::Point(6, 4), 4, &test.scene.views[9]);
  const cv::Mat punched = test.scene.views[9].mask;
  const RepairedScene filled = Fill(test);
  ASSERT_EQ(filled.gaps.size(), 2u);
  EXPECT_EQ(filled.gaps[0].view, 2u);
  EXPECT_EQ(filled.gaps[1].view, 9u);
  EXPECT_GT(filled.gaps[0].num_pixels, filled.gaps[1].num_pixels);
  for (size_t v = 0; v < exact.scene.views.size(); ++v) {
    EXPECT_EQ(Difference(filled.scene.views[v], exact.scene.views[v]), 0);
  }
  // The scene that was given is as it was.
  EXPECT_EQ(punched.at<uint8_t>(Middle(test.scene.views[9]) + cv::Point(6, 4)),
            0);
}

TEST(FalseGaps, AreNotWhatOtherViewsSeeThrough) {
  const TestScene test = MakeTestScene("torus", 240, 180, 36);
  size_t num_gaps = 0;
  for (const View& view : test.scene.views) {
    num_gaps += FindMaskGaps(view.mask, kTolerance).size();
  }
  ASSERT_GT(num_gaps, 0u);
  EXPECT_TRUE(Fill(test).gaps.empty());
}

// Three fingers stand close together.
TEST(FalseGaps, AreNotBaysOfTheObject) {
  const TestScene test = MakeTestScene("fingers", 240, 180, 24);
  size_t num_bays = 0;
  for (const View& view : test.scene.views) {
    for (const MaskGap& gap : FindMaskGaps(view.mask, 1)) {
      num_bays += gap.is_enclosed ? 0 : 1;
    }
  }
  ASSERT_GT(num_bays, 10u);
  EXPECT_TRUE(
      FillFalseGaps(test.scene, test.region.cube, 1, Context(2)).gaps.empty());
}

TEST(FalseGaps, AreBitesThatOtherViewsDeny) {
  const TestScene exact = MakeTestScene("sphere", 320, 240, 20);
  TestScene test = exact;
  View& view = test.scene.views[5];
  const cv::Rect box = cv::boundingRect(view.mask > 127);
  Punch(cv::Point(box.x + 6, box.y + box.height / 2), 7, &view);
  ASSERT_TRUE(Fill(exact).gaps.empty());
  const RepairedScene filled = Fill(test);
  ASSERT_EQ(filled.gaps.size(), 1u);
  EXPECT_EQ(filled.gaps[0].view, 5u);
  const auto count_lost = [&](const View& other) {
    return cv::countNonZero((exact.scene.views[5].mask > 127) &
                            (other.mask <= 127));
  };
  EXPECT_LT(count_lost(filled.scene.views[5]), count_lost(view) / 4);
}

// A shadow that neighbouring views share is a hole that they confirm, but for
// what is behind it.
TEST(FalseGaps, AreFoundThoughNeighborsShareThem) {
  const TestScene exact = MakeTestScene("sphere");
  TestScene test = exact;
  const Eigen::Vector3d spot =
      exact.region.cube.Center() +
      0.42 * exact.region.cube.edge *
          (exact.scene.views[4].Center() - exact.region.cube.Center())
              .normalized();
  size_t num_punched = 0;
  for (View& view : test.scene.views) {
    const Eigen::Vector3d towards =
        (view.Center() - exact.region.cube.Center()).normalized();
    if (towards.dot((spot - exact.region.cube.Center()).normalized()) > 0.5) {
      const Eigen::Vector2d p = view.camera.Project(view.cam_from_world * spot);
      Punch({int(p.x()), int(p.y())}, 4, &view);
      ++num_punched;
    }
  }
  ASSERT_GE(num_punched, 3u);
  EXPECT_EQ(Fill(test).gaps.size(), num_punched);
}

TEST(FalseGaps, StayWithinTheTolerance) {
  TestScene test = MakeTestScene("sphere");
  Punch(Middle(test.scene.views[2]), 1, &test.scene.views[2]);
  EXPECT_TRUE(Fill(test).gaps.empty());
}

TEST(FalseGaps, AreTheSameForAnyNumberOfThreads) {
  TestScene test = MakeTestScene("sphere");
  for (View& view : test.scene.views) {
    Punch(Middle(view), 4, &view);
  }
  const RepairedScene one = Fill(test, 1);
  const RepairedScene three = Fill(test, 3);
  EXPECT_EQ(one.gaps.size(), test.scene.views.size());
  ASSERT_EQ(one.gaps.size(), three.gaps.size());
  for (size_t v = 0; v < test.scene.views.size(); ++v) {
    EXPECT_EQ(Difference(one.scene.views[v], three.scene.views[v]), 0);
  }
}

}  // namespace
}  // namespace octacut
