#include "core/print/resting_plane.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

const Context kOneThread(1);

// A unit sphere at (0, 0, 1) on the plane z = 0, turned by `world_from_table`,
// with a wall behind it that has more points than the table.
class RestingPlaneTest : public ::testing::Test {
 protected:
  RestingPlaneTest() : mesh_(Moved(Sphere(12), {0, 0, 1})) {
    around_.noise = 0.003;
    for (uint64_t i = 0; i < 300; ++i) {
      Add({4 * Draw(i, 0) - 2, 4 * Draw(i, 1) - 2, Noise(i)});
    }
    for (uint64_t i = 300; i < 800; ++i) {
      Add({3 + Noise(i), 4 * Draw(i, 0) - 2, 3 * Draw(i, 1)});
    }
    for (uint64_t i = 800; i < 1000; ++i) {  // anywhere
      Add({6 * Draw(i, 0) - 3, 6 * Draw(i, 1) - 3, 4 * Draw(i, 2)});
    }
    for (uint64_t i = 0; i < 2000; ++i) {  // on the object
      Add(mesh_.positions[i % mesh_.positions.size()]);
    }
    for (int i = 0; i < 8; ++i) {
      around_.camera_centers.emplace_back(-4, 0.5 * i - 2, 2);
    }
  }

  static double Draw(uint64_t i, uint64_t k) {
    return HashUniform(HashBits(i, k));
  }
  static double Noise(uint64_t i) { return 0.006 * (Draw(i, 7) - 0.5); }
  void Add(const Eigen::Vector3d& point) { around_.points.push_back(point); }

  IndexedMesh mesh_;
  Surroundings around_;
};

TEST_F(RestingPlaneTest, FindsTheTableInAnyFrame) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 0.3).normalized())
          .toRotationMatrix();
  for (const Eigen::Matrix3d& rotation :
       {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), turn}) {
    const auto moved = [&](std::vector<Eigen::Vector3d> points) {
      for (Eigen::Vector3d& point : points) {
        point = rotation * point + Eigen::Vector3d(3, 4, 5);
      }
      return points;
    };
    IndexedMesh mesh = mesh_;
    mesh.positions = moved(mesh.positions);
    const RestingPlane stand = FindRestingPlane(
        mesh,
        {moved(around_.points), moved(around_.camera_centers), around_.noise},
        kOneThread);
    const Eigen::Vector3d up = rotation.col(2);
    EXPECT_GT(stand.up.dot(up), 0.99999);  // 0.25 degrees
    EXPECT_NEAR(stand.offset, up.dot(Eigen::Vector3d(3, 4, 5)), 0.003);
    EXPECT_NEAR(stand.gap, 0, 0.01);
    EXPECT_GE(stand.num_points, 290u);
    EXPECT_LE(stand.num_points, 320u);
    EXPECT_LE(stand.num_candidates, 1000u);
    EXPECT_NEAR(stand.rms, 0.0018, 0.001);
  }
}

TEST_F(RestingPlaneTest, ATableThatTheObjectDoesNotTouchIsNone) {
  for (Eigen::Vector3d& position : mesh_.positions) {
    position.z() += 1;
  }
  EXPECT_THROW(FindRestingPlane(mesh_, around_, kOneThread), InputError);
}

TEST_F(RestingPlaneTest, NoPointsAreAnError) {
  around_.points.clear();
  EXPECT_THROW(FindRestingPlane(mesh_, around_, kOneThread), InputError);
}

}  // namespace
}  // namespace octacut
