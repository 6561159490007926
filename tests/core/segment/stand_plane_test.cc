#include "core/segment/stand_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/hash.h"
#include "tests/core/segment/ring_scene.h"

namespace octacut::testing {
namespace {

double Random(uint64_t a, uint64_t b) {
  return 2 * HashUniform(HashBits(a, b)) - 1;
}

class StandPlaneTest : public ::testing::Test {
 protected:
  StandPlaneTest() {
    // A ball with a flat top, which has more points than the plate that it
    // stands on, tilted by ten degrees.
    const Eigen::Matrix3d tilt =
        Eigen::AngleAxisd(std::numbers::pi / 18, Eigen::Vector3d::UnitX())
            .toRotationMatrix();
    normal_ = tilt * Eigen::Vector3d::UnitZ();
    for (uint64_t i = 0; i < 300; ++i) {
      const Eigen::Vector3d top(0.3 * Random(i, 1), 0.3 * Random(i, 2), 0.3);
      object_.push_back(tilt * top);
      const Eigen::Vector3d side(Random(i, 3), Random(i, 4), Random(i, 5));
      object_.push_back(tilt * (0.5 * side.normalized()));
    }
    for (uint64_t i = 0; i < 200; ++i) {
      const double angle = std::numbers::pi * Random(i, 6);
      const double radius = 0.7 + 0.2 * Random(i, 7);
      plate_.push_back(tilt * Eigen::Vector3d(radius * std::cos(angle),
                                              radius * std::sin(angle),
                                              -0.5 + 2e-3 * Random(i, 8)));
    }
  }

  std::vector<Pose> poses_ = RingPoses(12);
  SearchRegion region_ = FindSearchRegion(poses_, {});
  std::vector<Eigen::Vector3d> object_;
  std::vector<Eigen::Vector3d> plate_;
  Eigen::Vector3d normal_;
};

TEST_F(StandPlaneTest, IsThatOfThePlate) {
  std::vector<Eigen::Vector3d> points = object_;
  points.insert(points.end(), plate_.begin(), plate_.end());
  const std::optional<StandPlane> stand =
      FindStandPlane(points, poses_, region_);
  ASSERT_TRUE(stand);
  EXPECT_GT(stand->plane.normal().dot(normal_), std::cos(0.01));
  EXPECT_NEAR(stand->plane.signedDistance(Eigen::Vector3d::Zero()), 0.5, 0.01);
}

TEST_F(StandPlaneTest, MayHaveFewOfThePoints) {
  plate_.resize(45);  // of 645
  std::vector<Eigen::Vector3d> points = object_;
  points.insert(points.end(), plate_.begin(), plate_.end());
  const std::optional<StandPlane> stand =
      FindStandPlane(points, poses_, region_);
  ASSERT_TRUE(stand);
  EXPECT_GT(stand->plane.normal().dot(normal_), std::cos(0.01));
  EXPECT_NEAR(stand->plane.signedDistance(Eigen::Vector3d::Zero()), 0.5, 0.01);
}

TEST_F(StandPlaneTest, ThereMustBeOne) {
  EXPECT_FALSE(FindStandPlane(object_, poses_, region_));
  plate_.resize(20);
  EXPECT_FALSE(FindStandPlane(plate_, poses_, region_));
}

}  // namespace
}  // namespace octacut::testing
