#include "core/benchmark/synthetic/rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/base/error.h"

namespace octacut {
namespace {

TEST(Lens, UnprojectsWhatItProjects) {
  RigOptions options;
  for (const double k1 : {0.0, 0.1, -0.12, 0.3}) {
    options.k1 = k1;
    const Lens lens = MakeLens(options);
    for (int y = 0; y <= options.height; y += 64) {
      for (int x = 0; x <= options.width; x += 64) {
        const Eigen::Vector2d pixel(x, y);
        const Eigen::Vector3d ray = lens.Unproject(pixel);
        EXPECT_EQ(ray.z(), 1);
        EXPECT_LT((lens.Project(3.7 * ray) - pixel).norm(), 1e-8);
      }
    }
  }
}

TEST(Lens, DistortsAsSimpleRadialDoes) {
  const Lens lens{{100, 100, 80, 80, 50, 50}, 0.1};
  const Eigen::Vector2d pixel = lens.Project({0.3, -0.4, 1});
  EXPECT_NEAR(pixel.x(), 50 + 80 * 0.3 * 1.025, 1e-12);
  EXPECT_NEAR(pixel.y(), 50 - 80 * 0.4 * 1.025, 1e-12);
}

class Rigs : public ::testing::TestWithParam<RigKind> {};

TEST_P(Rigs, CamerasLookAtTheWholeObject) {
  RigOptions options;
  options.kind = GetParam();
  const Eigen::Vector3d center(3, -1, 2);
  const double radius = 0.7;
  const std::vector<Rigid3d> rig = MakeRig(options, center, radius);
  ASSERT_EQ(rig.size(), 36u);
  const Lens lens = MakeLens(options);
  for (const Rigid3d& cam_from_world : rig) {
    EXPECT_NEAR(cam_from_world.rotation.determinant(), 1, 1e-12);
    EXPECT_LT((cam_from_world.rotation.transpose() * cam_from_world.rotation -
               Eigen::Matrix3d::Identity())
                  .norm(),
              1e-12);
    const Eigen::Vector2d middle = lens.Project(cam_from_world * center);
    EXPECT_NEAR(middle.x(), options.width / 2.0, 1e-9);
    EXPECT_NEAR(middle.y(), options.height / 2.0, 1e-9);
    // z is upward in the image.
    const Eigen::Vector2d above =
        lens.Project(cam_from_world * (center + Eigen::Vector3d(0, 0, 0.1)));
    EXPECT_LT(above.y(), middle.y());
    const double elevation =
        std::asin(
            (cam_from_world.Inverse().translation - center).normalized().z()) *
        180 / std::numbers::pi;
    EXPECT_GE(elevation, options.min_elevation - 1e-9);
    EXPECT_LE(elevation, options.max_elevation + 1e-9);
  }
}

TEST_P(Rigs, TheBoundingSphereFillsTheImageAsAsked) {
  RigOptions options;
  options.kind = GetParam();
  options.fill = 0.8;
  const double radius = 0.7;
  const Rigid3d pose =
      MakeRig(options, Eigen::Vector3d::Zero(), radius).front();
  const Lens lens = MakeLens(options);
  const double distance = pose.translation.norm();
  const double seen = lens.camera.fy * std::tan(std::asin(radius / distance));
  EXPECT_NEAR(2 * seen, 0.8 * options.height, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Kinds,
                         Rigs,
                         ::testing::Values(RigKind::kSphere,
                                           RigKind::kRings,
                                           RigKind::kTurntable));

TEST(MakeRig, TurntableStaysAtOneElevation) {
  RigOptions options;
  options.kind = RigKind::kTurntable;
  options.min_elevation = 22;
  options.max_elevation = 22;
  for (const Rigid3d& pose : MakeRig(options, Eigen::Vector3d::Zero(), 1)) {
    const Eigen::Vector3d eye = pose.Inverse().translation.normalized();
    EXPECT_NEAR(eye.z(), std::sin(22 * std::numbers::pi / 180), 1e-12);
  }
}

TEST(MakeRig, EverySecondCameraMayStandFar) {
  RigOptions options;
  const std::vector<Rigid3d> near = MakeRig(options, {0, 0, 0}, 1);
  options.far_factor = 3;
  const std::vector<Rigid3d> rig = MakeRig(options, {0, 0, 0}, 1);
  for (size_t i = 0; i < rig.size(); ++i) {
    EXPECT_NEAR(rig[i].translation.norm(),
                (i % 2 == 1 ? 3 : 1) * near[i].translation.norm(),
                1e-9);
    EXPECT_LT((rig[i].rotation - near[i].rotation).norm(), 1e-12);
  }
}

TEST(MakeRig, LooksStraightDownToo) {
  const Rigid3d pose = LookAt({0, 0, 5}, {0, 0, 0});
  EXPECT_NEAR(pose.rotation.determinant(), 1, 1e-12);
  EXPECT_NEAR((pose * Eigen::Vector3d(0, 0, 0)).z(), 5, 1e-12);
}

TEST(RigOptions, RefusesBadValues) {
  const auto refused = [](auto change) {
    RigOptions options;
    change(options);
    EXPECT_THROW(options.Check(), OptionError);
  };
  refused([](RigOptions& o) { o.num_views = 0; });
  refused([](RigOptions& o) { o.min_elevation = 85; });
  refused([](RigOptions& o) { o.max_elevation = 95; });
  refused([](RigOptions& o) { o.width = 2; });
  refused([](RigOptions& o) { o.height = 0; });
  refused([](RigOptions& o) { o.focal_length = 0; });
  refused([](RigOptions& o) { o.fill = 0; });
  refused([](RigOptions& o) { o.far_factor = 0.5; });
  refused([](RigOptions& o) { o.k1 = -0.5; });
  EXPECT_NO_THROW(RigOptions{}.Check());
}

}  // namespace
}  // namespace octacut
