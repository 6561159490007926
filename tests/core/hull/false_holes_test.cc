#include "core/hull/false_holes.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "core/hull/mask_holes.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::MakeTestScene;
using testing::TestScene;

constexpr double kTolerance = 2;

FilledScene Fill(const TestScene& test, int num_threads = 2) {
  return FillFalseHoles(
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

TEST(FalseHoles, AreFilledAndNothingElse) {
  const TestScene exact = MakeTestScene("sphere");
  TestScene test = exact;
  Punch(Middle(test.scene.views[2]), 5, &test.scene.views[2]);
  Punch(Middle(test.scene.views[9]) + cv::Point(6, 4), 4, &test.scene.views[9]);
  const cv::Mat punched = test.scene.views[9].mask;
  const FilledScene filled = Fill(test);
  ASSERT_EQ(filled.holes.size(), 2u);
  EXPECT_EQ(filled.holes[0].view, 2u);
  EXPECT_EQ(filled.holes[1].view, 9u);
  EXPECT_GT(filled.holes[0].num_pixels, filled.holes[1].num_pixels);
  for (size_t v = 0; v < exact.scene.views.size(); ++v) {
    EXPECT_EQ(Difference(filled.scene.views[v], exact.scene.views[v]), 0);
  }
  // The scene that was given is as it was.
  EXPECT_EQ(punched.at<uint8_t>(Middle(test.scene.views[9]) + cv::Point(6, 4)),
            0);
}

TEST(FalseHoles, AreNotWhatOtherViewsSeeThrough) {
  const TestScene test = MakeTestScene("torus", 240, 180, 36);
  size_t num_holes = 0;
  for (const View& view : test.scene.views) {
    num_holes += FindMaskHoles(view.mask, kTolerance, 0.05).size();
  }
  ASSERT_GT(num_holes, 0u);
  EXPECT_TRUE(Fill(test).holes.empty());
}

// A shadow that neighbouring views share is a hole that they confirm, but for
// what is behind it.
TEST(FalseHoles, AreFoundThoughNeighborsShareThem) {
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
  EXPECT_EQ(Fill(test).holes.size(), num_punched);
}

TEST(FalseHoles, StayWithinTheTolerance) {
  TestScene test = MakeTestScene("sphere");
  Punch(Middle(test.scene.views[2]), 1, &test.scene.views[2]);
  EXPECT_TRUE(Fill(test).holes.empty());
}

TEST(FalseHoles, AreTheSameForAnyNumberOfThreads) {
  TestScene test = MakeTestScene("sphere");
  for (View& view : test.scene.views) {
    Punch(Middle(view), 4, &view);
  }
  const FilledScene one = Fill(test, 1);
  const FilledScene three = Fill(test, 3);
  EXPECT_EQ(one.holes.size(), test.scene.views.size());
  ASSERT_EQ(one.holes.size(), three.holes.size());
  for (size_t v = 0; v < test.scene.views.size(); ++v) {
    EXPECT_EQ(Difference(one.scene.views[v], three.scene.views[v]), 0);
  }
}

}  // namespace
}  // namespace octacut
