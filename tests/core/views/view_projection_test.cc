#include "core/views/view_projection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/views/random_views.h"

namespace octacut {
namespace {

using testing::Random;
using testing::RandomViewOfCube;
using testing::ToUnit;
using testing::ToWorld;
using testing::ViewOfCube;

TEST(ViewProjection, IsTheCamerasProjection) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const ViewOfCube v = RandomViewOfCube(random, 10);
    const ViewProjection projection = MakeViewProjection(v.view, v.cube);
    for (int k = 0; k < 20; ++k) {
      const Eigen::Vector3d x = random.Point(0, 1);
      const Eigen::Vector3d in_cam = v.view.cam_from_world * ToWorld(v.cube, x);
      const Eigen::Vector2d expected = v.view.camera.Project(in_cam);
      const auto point = projection.Project(x.cast<float>());
      ASSERT_TRUE(point);
      EXPECT_NEAR(point->u, expected.x(), 2e-3);
      EXPECT_NEAR(point->v, expected.y(), 2e-3);
      EXPECT_NEAR(point->depth, in_cam.z() / v.cube.edge, 1e-5);
    }
  }
}

TEST(ViewProjection, KeepsItsDigitsFarFromTheOrigin) {
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    ViewOfCube v = RandomViewOfCube(random, 1e5);
    const ViewProjection projection = MakeViewProjection(v.view, v.cube);
    const Eigen::Vector3d x = random.Point(0, 1);
    const Eigen::Vector2d expected =
        v.view.camera.Project(v.view.cam_from_world * ToWorld(v.cube, x));
    const auto point = projection.Project(x.cast<float>());
    ASSERT_TRUE(point);
    EXPECT_NEAR(point->u, expected.x(), 5e-3);
    EXPECT_NEAR(point->v, expected.y(), 5e-3);
  }
}

TEST(ViewProjection, KnowsCentreAndFrame) {
  Random random(3);
  const ViewOfCube v = RandomViewOfCube(random, 5);
  const ViewProjection projection = MakeViewProjection(v.view, v.cube);
  EXPECT_LT((projection.center.cast<double>() - ToUnit(v.cube, v.view.Center()))
                .norm(),
            1e-5);
  EXPECT_EQ(projection.width, v.view.camera.width);
  EXPECT_EQ(projection.height, v.view.camera.height);
  EXPECT_TRUE(projection.InFrame(0, 0));
  EXPECT_TRUE(projection.InFrame(float(projection.width), 1));
  EXPECT_FALSE(projection.InFrame(-0.01f, 1));
  EXPECT_FALSE(projection.InFrame(1, float(projection.height) + 0.01f));
  EXPECT_FALSE(projection.InFrame(std::nanf(""), 1));
}

TEST(ViewProjection, ShowsNothingBehindTheCamera) {
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const ViewOfCube v = RandomViewOfCube(random, 5);
    const ViewProjection projection = MakeViewProjection(v.view, v.cube);
    const Eigen::Vector3f behind =
        projection.center -
        float(random.Uniform(0.1, 2)) * projection.linear.row(2).transpose();
    EXPECT_LT(projection.Homogeneous(behind).z(), 0);
    EXPECT_FALSE(projection.Project(behind));
    EXPECT_FALSE(projection.ProjectIntoFrame(behind));
  }
}

TEST(ViewProjection, TellsPointsInTheFrameFromThoseBesideIt) {
  Random random(6);
  const ViewOfCube v = RandomViewOfCube(random, 5);
  const ViewProjection projection = MakeViewProjection(v.view, v.cube);
  const Eigen::Matrix3f rays = projection.linear.inverse();
  const auto at = [&](float u, float v_pixel) -> Eigen::Vector3f {
    return projection.center + 2 * (rays * Eigen::Vector3f(u, v_pixel, 1));
  };
  const float width = float(projection.width);
  const auto inside = projection.ProjectIntoFrame(at(width - 1, 1));
  ASSERT_TRUE(inside);
  EXPECT_NEAR(inside->u, width - 1, 1e-2);
  EXPECT_NEAR(inside->v, 1, 1e-2);
  EXPECT_NEAR(inside->depth, 2, 1e-4);
  const auto beside = projection.Project(at(width + 1, 1));
  ASSERT_TRUE(beside);
  EXPECT_NEAR(beside->u, width + 1, 1e-2);
  EXPECT_FALSE(projection.ProjectIntoFrame(at(width + 1, 1)));
}

TEST(ViewProjection, FootprintIsWhatALengthAcrossTheRayCovers) {
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    ViewOfCube v = RandomViewOfCube(random, 5);
    v.view.camera.fy = v.view.camera.fx;
    const ViewProjection projection = MakeViewProjection(v.view, v.cube);
    const float depth = 2;
    const float length = 0.125f;
    const Eigen::Vector3f a =
        projection.center + depth * projection.linear.row(2).transpose();
    const Eigen::Vector3f b =
        a + length *
                v.view.cam_from_world.rotation.row(0).transpose().cast<float>();
    const auto pa = projection.Project(a);
    const auto pb = projection.Project(b);
    ASSERT_TRUE(pa && pb);
    EXPECT_NEAR(std::hypot(pb->u - pa->u, pb->v - pa->v),
                projection.Footprint(length, depth),
                1e-2);
  }
}

TEST(VoxelCenter, IsTheMiddleOfTheVoxel) {
  const Eigen::Vector3f center = VoxelCenter({0, 3, 7}, 3);
  EXPECT_EQ(center, Eigen::Vector3f(0.5f / 8, 3.5f / 8, 7.5f / 8));
  EXPECT_EQ(VoxelCenter({0, 0, 0}, 0), Eigen::Vector3f::Constant(0.5f));
}

TEST(ViewProjection, CloseUpsCountAsIfTheCentreWereBeforeThem) {
  Random random(4);
  ViewOfCube v = RandomViewOfCube(random, 5);
  const auto footprint_at = [&](double depth) {
    // The cube's centre at that depth.
    v.view.cam_from_world.translation +=
        (depth * v.cube.edge - (v.view.cam_from_world * v.cube.Center()).z()) *
        Eigen::Vector3d::UnitZ();
    return MakeViewProjection(v.view, v.cube).CenterFootprint(0.01f);
  };
  const float focal_length = MakeViewProjection(v.view, v.cube).focal_length;
  EXPECT_NEAR(footprint_at(2), 0.01f * focal_length / 2, 1e-3);
  for (const double depth : {0.1, 0.0, -3.0}) {
    EXPECT_NEAR(footprint_at(depth), 0.01f * focal_length / 0.25f, 1e-3);
  }
}

}  // namespace
}  // namespace octacut
