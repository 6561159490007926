#include "core/segment/occupancy.h"

#include <gtest/gtest.h>

#include "tests/core/segment/ring_scene.h"

namespace octacut {
namespace {

using testing::Ball;
using testing::RingPoses;
using testing::SilhouetteOf;

// Log odds of +-4 as silhouettes have it.
std::vector<cv::Mat> OddsOf(const std::vector<Ball>& balls,
                            const std::vector<Pose>& poses) {
  std::vector<cv::Mat> result;
  for (const Pose& pose : poses) {
    cv::Mat odds(pose.camera.height, pose.camera.width, CV_32F, cv::Scalar(-4));
    for (const Ball& ball : balls) {
      odds.setTo(4, SilhouetteOf(ball, pose));
    }
    result.push_back(odds);
  }
  return result;
}

BoundingCube CubeOfEdge(double edge) {
  return {Eigen::Vector3d::Constant(-edge / 2), edge};
}

TEST(Occupancy, FindsWhatTheSilhouettesShow) {
  const std::vector<Pose> poses = RingPoses(16);
  const Ball ball = {{0.1, -0.05, 0.05}, 0.4};
  OccupancyGrid grid(
      CubeOfEdge(2), 64, {}, poses, OddsOf({ball}, poses), Context(2));
  ASSERT_TRUE(grid.KeepMainComponent(Eigen::Vector3d::Zero(), 1, false));
  const Eigen::AlignedBox3d box = grid.ObjectBox();
  // Two voxels; nobody looks from straight above or below.
  EXPECT_LT((box.center() - ball.center).cwiseAbs().maxCoeff(), 0.07);
  EXPECT_NEAR(box.sizes().x(), 0.8, 0.08);
  EXPECT_NEAR(box.sizes().y(), 0.8, 0.08);
}

TEST(Occupancy, TheOriginOfTheWorldDoesNotMatter) {
  std::vector<Pose> poses = RingPoses(16);
  const Ball ball = {{0.1, -0.05, 0.05}, 0.4};
  const std::vector<cv::Mat> odds = OddsOf({ball}, poses);
  // As in a frame of the earth's centre.
  const Eigen::Vector3d shift(4e6, -5e6, 1e6);
  for (Pose& pose : poses) {
    pose.cam_from_world.translation -= pose.cam_from_world.rotation * shift;
  }
  BoundingCube cube = CubeOfEdge(2);
  cube.min_corner += shift;
  OccupancyGrid grid(cube, 64, {}, poses, odds, Context(2));
  ASSERT_TRUE(grid.KeepMainComponent(shift, 1, false));
  const Eigen::AlignedBox3d box = grid.ObjectBox();
  EXPECT_LT((box.center() - shift - ball.center).cwiseAbs().maxCoeff(), 0.07);
  EXPECT_GT(testing::Overlap(grid.LogOddsOfOthers(3) > 0, odds[3] > 0), 0.8);
}

TEST(Occupancy, OneViewThatSeesNothingIsOverruled) {
  const std::vector<Pose> poses = RingPoses(16);
  const Ball ball;
  std::vector<cv::Mat> odds = OddsOf({ball}, poses);
  odds[5].setTo(-4);
  OccupancyGrid grid(CubeOfEdge(2), 64, {}, poses, odds, Context(2));
  ASSERT_TRUE(grid.KeepMainComponent(Eigen::Vector3d::Zero(), 1, false));
  EXPECT_NEAR(grid.ObjectBox().sizes().x(), 1, 0.1);
  // To that view the others say where the ball is.
  const cv::Mat log_odds = grid.LogOddsOfOthers(5);
  const cv::Mat truth = SilhouetteOf(ball, poses[5]);
  EXPECT_EQ(cv::countNonZero(truth & (log_odds <= 0)), 0);
  EXPECT_GT(testing::Overlap(log_odds > 0, truth), 0.8);
}

TEST(Occupancy, ThingsBesideTheMiddleAreBackground) {
  const std::vector<Pose> poses = RingPoses(16);
  const Ball ball = {{0, 0, 0}, 0.3};
  const Ball other = {{0.8, 0, 0}, 0.15};
  OccupancyGrid grid(
      CubeOfEdge(2.2), 64, {}, poses, OddsOf({ball, other}, poses), Context(2));
  EXPECT_GT(grid.ObjectBox().max().x(), 0.8);
  ASSERT_TRUE(grid.KeepMainComponent(Eigen::Vector3d::Zero(), 1, false));
  EXPECT_NEAR(grid.ObjectBox().max().x(), 0.3, 0.1);
}

TEST(Occupancy, SeveredPartsAreKeptIfTheyAreLargeEnough) {
  const std::vector<Pose> poses = RingPoses(16);
  const Ball ball = {{0, 0, 0}, 0.3};
  for (const double radius : {0.15, 0.06}) {  // 12.5 and 0.8 % of its volume
    const Ball part = {{0.8, 0, 0}, radius};
    OccupancyGrid grid(CubeOfEdge(2.2),
                       64,
                       {},
                       poses,
                       OddsOf({ball, part}, poses),
                       Context(2));
    EXPECT_GT(grid.ObjectBox().max().x(), 0.8);
    ASSERT_TRUE(grid.KeepMainComponent(Eigen::Vector3d::Zero(), 1, true));
    EXPECT_NEAR(grid.ObjectBox().max().x(), radius > 0.1 ? 0.95 : 0.3, 0.1);
  }
}

// Two views deny something that all others show beside the object: without one
// of them it would be there again.
TEST(Occupancy, WhatIsFarFromTheObjectDoesNotComeBack) {
  const std::vector<Pose> poses = RingPoses(16);
  const Ball ball = {{0, 0, 0}, 0.3};
  const Ball other = {{0.8, 0, 0}, 0.15};
  std::vector<cv::Mat> odds = OddsOf({ball, other}, poses);
  for (const size_t i : {2, 5}) {
    odds[i] = OddsOf({ball}, poses)[i];
  }
  OccupancyGrid grid(CubeOfEdge(2.2), 64, {}, poses, odds, Context(2));
  ASSERT_TRUE(grid.KeepMainComponent(Eigen::Vector3d::Zero(), 1, false));
  for (const size_t i : {2, 5}) {
    const cv::Mat beside = SilhouetteOf(other, poses[i]) &
                           ~SilhouetteOf({{0, 0, 0}, 0.4}, poses[i]);
    EXPECT_EQ(cv::countNonZero((grid.LogOddsOfOthers(i) > 0) & beside), 0) << i;
  }
}

TEST(Occupancy, NothingIsFoundWhereNothingIs) {
  const std::vector<Pose> poses = RingPoses(8);
  OccupancyGrid grid(
      CubeOfEdge(2), 32, {}, poses, OddsOf({}, poses), Context(2));
  EXPECT_FALSE(grid.KeepMainComponent(Eigen::Vector3d::Zero(), 1, false));
  EXPECT_TRUE(grid.ObjectBox().isEmpty());
}

TEST(Occupancy, AGivenBoxBoundsIt) {
  const std::vector<Pose> poses = RingPoses(16);
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-1, -1, 0),
                                Eigen::Vector3d(1, 1, 1));
  OccupancyGrid grid(CubeOfEdge(2),
                     64,
                     {.box = box, .floor = {}},
                     poses,
                     OddsOf({Ball()}, poses),
                     Context(2));
  ASSERT_TRUE(grid.KeepMainComponent(Eigen::Vector3d::Zero(), 1, false));
  EXPECT_GE(grid.ObjectBox().min().z(), -1e-9);
  EXPECT_NEAR(grid.ObjectBox().max().z(), 0.5, 0.1);
}

}  // namespace
}  // namespace octacut
