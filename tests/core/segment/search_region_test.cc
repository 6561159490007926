#include "core/segment/search_region.h"

#include <gmock/gmock.h>

#include "core/base/error.h"
#include "tests/core/segment/ring_scene.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using testing::RingPose;
using testing::RingPoses;
using ::testing::ThrowsMessage;

TEST(SearchRegion, IsWhereTheCamerasLook) {
  const SearchRegion region = FindSearchRegion(RingPoses(12), {});
  EXPECT_LT(region.center.norm(), 1e-6);
  // Half of the picture's height at the distance of the object.
  EXPECT_NEAR(
      region.radius,
      testing::kRingDistance * testing::kRingHeight / 2 / testing::kRingFocal,
      1e-6);
  EXPECT_LT((region.cube.Center() - region.center).norm(), 1e-9);
  EXPECT_GE(region.cube.edge, 2 * region.radius);
}

TEST(SearchRegion, OneCameraThatLooksAwayMovesItHardly) {
  std::vector<Pose> poses = RingPoses(12);
  poses[3].cam_from_world.rotation =
      Eigen::AngleAxisd(0.15, Eigen::Vector3d::UnitY()) *
      poses[3].cam_from_world.rotation;
  poses[3].cam_from_world.translation =
      Eigen::AngleAxisd(0.15, Eigen::Vector3d::UnitY()) *
      poses[3].cam_from_world.translation;
  // The axis passes the origin at 0.6; the mean of all would be 0.05 off.
  EXPECT_LT(FindSearchRegion(poses, {}).center.norm(), 0.01);
}

TEST(SearchRegion, AGivenBoxCounts) {
  const Eigen::AlignedBox3d box(Eigen::Vector3d(0.1, -0.3, -0.2),
                                Eigen::Vector3d(0.5, 0.1, 0.4));
  const SearchRegion region = FindSearchRegion(RingPoses(12), box);
  EXPECT_LT((region.center - box.center()).norm(), 1e-12);
  EXPECT_NEAR(region.cube.edge, 0.6, 1e-12);
}

TEST(SearchRegion, RefusesWhatSaysNothing) {
  const std::vector<Pose> two = RingPoses(2);
  EXPECT_THAT([&] { FindSearchRegion(two, {}); },
              ThrowsMessage<InputError>(HasSubstr("2 views; at least 3")));
  const std::vector<Pose> same(5, RingPose(0.3, 0.2));
  EXPECT_THAT([&] { FindSearchRegion(same, {}); },
              ThrowsMessage<InputError>(HasSubstr("the same direction")));
  const Eigen::AlignedBox3d away(Eigen::Vector3d(8, 8, 8),
                                 Eigen::Vector3d(9, 9, 9));
  EXPECT_THAT([&] { FindSearchRegion(RingPoses(6), away); },
              ThrowsMessage<InputError>(HasSubstr("bounding_box: only")));
}

}  // namespace
}  // namespace octacut
