#include "core/hull/point_gaps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/pixel_distance.h"
#include "tests/core/base/recorder.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::MakeTestScene;
using testing::Recorder;
using testing::TestScene;
using testing::TestSpec;

constexpr double kGapTolerance = 2;

TestScene SceneWithPoints(const std::string& object) {
  return MakeTestScene(testing::RenderOnce(object, [](const std::string& name) {
    SceneSpec spec = TestSpec(name, 240, 180, 24);
    spec.num_points = 4000;
    return spec;
  }));
}

cv::Point PixelOf(const View& view, const Eigen::Vector3d& point) {
  const Eigen::Vector2d pixel =
      view.camera.Project(view.cam_from_world * point);
  return {int(pixel.x()), int(pixel.y())};
}

// As a dark place of the object's surface does: background around the same
// point in all views that are near to each other.
std::vector<size_t> Darken(const Eigen::Vector3d& place,
                           size_t num_views,
                           Scene* scene) {
  std::vector<std::pair<double, size_t>> nearest;
  for (size_t v = 0; v < scene->views.size(); ++v) {
    nearest.emplace_back((scene->views[v].Center() - place).norm(), v);
  }
  std::sort(nearest.begin(), nearest.end());
  std::vector<size_t> views;
  for (size_t i = 0; i < num_views; ++i) {
    View& view = scene->views[nearest[i].second];
    view.mask = view.mask.clone();
    cv::circle(view.mask, PixelOf(view, place), 10, cv::Scalar(0), cv::FILLED);
    views.push_back(nearest[i].second);
  }
  std::sort(views.begin(), views.end());
  return views;
}

size_t CountDifferent(const cv::Mat& a, const cv::Mat& b) {
  return size_t(
      cv::countNonZero((a >= kObjectThreshold) != (b >= kObjectThreshold)));
}

std::set<size_t> FilledViews(const RepairedScene& filled) {
  std::set<size_t> views;
  for (const FalseGap& gap : filled.gaps) {
    views.insert(gap.view);
  }
  return views;
}

TEST(FillGapsAtPoints, FillsAShadowThatViewsShare) {
  const TestScene exact = SceneWithPoints("sphere");
  Scene scene = exact.scene;
  const Eigen::Vector3d place =
      exact.region.cube.Center() + Eigen::Vector3d(0, 0, 0.2);
  const std::vector<size_t> dark = Darken(place, 4, &scene);
  const RepairedScene filled =
      FillGapsAtPoints(scene, kGapTolerance, Context(2));
  EXPECT_EQ(FilledViews(filled), std::set<size_t>(dark.begin(), dark.end()));
  for (const size_t v : dark) {
    const size_t missing =
        CountDifferent(scene.views[v].mask, exact.scene.views[v].mask);
    const size_t left =
        CountDifferent(filled.scene.views[v].mask, exact.scene.views[v].mask);
    EXPECT_GT(missing, 250u);
    EXPECT_LT(left, missing / 3) << v;
  }
  // The scene that was given is as it was.
  EXPECT_GT(CountDifferent(scene.views[dark[0]].mask,
                           exact.scene.views[dark[0]].mask),
            250u);
}

// A shadow that reaches across the object's border is filled hardly farther
// than the object reaches.
TEST(FillGapsAtPoints, StopsWhereThePointsEnd) {
  const TestScene exact = SceneWithPoints("sphere");
  Scene scene = exact.scene;
  View& view = scene.views[3];
  const cv::Mat object = view.mask >= kObjectThreshold;
  const cv::Rect box = cv::boundingRect(object);
  view.mask = view.mask.clone();
  const cv::Point left(box.x, box.y + box.height / 2);
  cv::circle(view.mask, left, 12, cv::Scalar(0), cv::FILLED);
  const RepairedScene filled =
      FillGapsAtPoints(scene, kGapTolerance, Context(2));
  EXPECT_EQ(FilledViews(filled), std::set<size_t>{3});
  const cv::Mat after = filled.scene.views[3].mask >= kObjectThreshold;
  const cv::Mat before = view.mask >= kObjectThreshold;
  const int missing = cv::countNonZero(object & ~before);
  EXPECT_LT(cv::countNonZero(object & ~after), missing / 3);
  // The disc has a radius of 3.3 pixels.
  EXPECT_EQ(cv::countNonZero(after & ~PixelsNear(object, 4)), 0);
}

TEST(FillGapsAtPoints, LeavesRightMasksAlone) {
  for (const char* object : {"torus", "fingers", "cup"}) {
    const TestScene test = SceneWithPoints(object);
    ASSERT_GT(test.scene.points.size(), 1500u) << object;
    EXPECT_TRUE(
        FillGapsAtPoints(test.scene, kGapTolerance, Context(2)).gaps.empty())
        << object;
  }
}

// Two wrong points in the hole of a torus, and half a mask that is missing.
TEST(FillGapsAtPoints, LeavesWhatFewPointsOrTooManyPixelsSpeakFor) {
  TestScene test = SceneWithPoints("torus");
  test.scene.points.push_back(test.region.cube.Center());
  test.scene.points.push_back(test.region.cube.Center());
  View& view = test.scene.views[5];
  view.mask = view.mask.clone();
  view.mask.colRange(0, PixelOf(view, test.region.cube.Center()).x).setTo(0);
  Recorder sink;
  EXPECT_TRUE(FillGapsAtPoints(test.scene, kGapTolerance, Context(2, &sink))
                  .gaps.empty());
  // The mask that is left as it is is named.
  EXPECT_THAT(sink.infos, ElementsAre(HasSubstr(": " + view.name + ".")));
}

TEST(FillGapsAtPoints, NeedsManyPoints) {
  TestScene test = SceneWithPoints("sphere");
  Darken(test.region.cube.Center(), 1, &test.scene);
  EXPECT_EQ(FillGapsAtPoints(test.scene, kGapTolerance, Context(2)).gaps.size(),
            1u);
  test.scene.points.resize(500);
  EXPECT_TRUE(
      FillGapsAtPoints(test.scene, kGapTolerance, Context(2)).gaps.empty());
  test.scene.points.clear();
  EXPECT_TRUE(
      FillGapsAtPoints(test.scene, kGapTolerance, Context(2)).gaps.empty());
}

TEST(FillGapsAtPoints, IsTheSameForAnyNumberOfThreads) {
  TestScene test = SceneWithPoints("sphere");
  Darken(test.region.cube.Center(), 6, &test.scene);
  const RepairedScene one = FillGapsAtPoints(test.scene, 0, Context(1));
  const RepairedScene four = FillGapsAtPoints(test.scene, 0, Context(4));
  EXPECT_EQ(FilledViews(one).size(), 6u);
  EXPECT_EQ(FilledViews(four), FilledViews(one));
  EXPECT_EQ(four.gaps.size(), one.gaps.size());
  for (size_t v = 0; v < test.scene.views.size(); ++v) {
    EXPECT_EQ(
        cv::norm(
            one.scene.views[v].mask, four.scene.views[v].mask, cv::NORM_INF),
        0);
  }
}

}  // namespace
}  // namespace octacut
