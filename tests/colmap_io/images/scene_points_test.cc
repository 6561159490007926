#include "colmap_io/images/scene_points.h"

#include <gtest/gtest.h>

#include "tests/colmap_io/images/test_workspace.h"

namespace octacut {
namespace {

using testing::RingModel;
using testing::RingPose;
using testing::SphereMask;

constexpr int kNumViews = 12;
const SparseCamera kSphereCamera = {
    1, camera_model::kPinhole, 320, 240, {300, 300, 160, 120}};

std::vector<View> SphereViews(const SparseModel& model) {
  std::vector<View> views;
  for (int i = 0; i < kNumViews; ++i) {
    View& view = views.emplace_back();
    view.name = model.images[i].name;
    view.camera = {320, 240, 300, 300, 160, 120};
    view.cam_from_world = RingPose(i, kNumViews);
    view.mask = SphereMask(kSphereCamera, view.cam_from_world, 0.8);
  }
  return views;
}

TEST(ScenePoints, KeepsAccuratePointsOnTheObject) {
  SparseModel model = RingModel(kSphereCamera, kNumViews);
  std::vector<View> views = SphereViews(model);
  std::vector<SparsePoint>& points = model.points;
  points.resize(7);
  for (SparsePoint& point : points) {
    point.error = 0.5;
    point.track = {{1, 0}, {2, 0}, {3, 0}, {9, 0}, {12, 0}};
  }
  points[1].xyz = {0, 0, 0.7};
  points[2].xyz = {0, 0, 1.2};  // off the object
  points[3].xyz = {0.1, 0, 0};
  points[3].error = 30;
  points[4].xyz = {0.2, 0, 0};
  points[4].track.resize(2);
  points[5].xyz = {0.3, 0, 0};
  points[5].error = -1;  // not known
  const auto kept = ScenePoints(model, views);
  ASSERT_EQ(kept.size(), 4u);
  EXPECT_EQ(kept[1], points[1].xyz);
  EXPECT_EQ(kept[2], points[5].xyz);
}

// Masks that miss a dark part of the object do not take its points.
TEST(ScenePoints, KeepsPointsOutsideOfAFifthOfTheMasks) {
  SparseModel model = RingModel(kSphereCamera, kNumViews);
  std::vector<View> views = SphereViews(model);
  SparsePoint point;
  point.error = 0.5;
  point.track = {{4, 0}, {5, 0}, {6, 0}};
  model.points = {point};
  views[0].mask.setTo(0);
  views[1].mask.setTo(0);
  EXPECT_EQ(ScenePoints(model, views).size(), 1u);
  views[2].mask.setTo(0);
  EXPECT_TRUE(ScenePoints(model, views).empty());
}

TEST(ScenePoints, DropsBackgroundThatIsHiddenOrOutOfSight) {
  SparseModel model = RingModel(kSphereCamera, kNumViews);
  std::vector<View> views = SphereViews(model);
  // Far behind the object for image 1, out of sight for most others.
  SparsePoint point;
  point.xyz = -3 * views[0].Center();
  point.error = 0.5;
  point.track = {{6, 0}, {7, 0}, {8, 0}};
  model.points = {point};
  EXPECT_TRUE(ScenePoints(model, views).empty());
  // Even where every view cuts the object off, so that none bounds it.
  for (View& view : views) {
    view.mask.row(0) = 255;
  }
  EXPECT_TRUE(ScenePoints(model, views).empty());
}

}  // namespace
}  // namespace octacut
