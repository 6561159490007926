#include "core/benchmark/synthetic/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace octacut {
namespace {

Eigen::Vector3f Direction(double azimuth, double elevation) {
  const double degree = std::numbers::pi / 180;
  return Eigen::Vector3d(
             std::cos(elevation * degree) * std::cos(azimuth * degree),
             std::cos(elevation * degree) * std::sin(azimuth * degree),
             std::sin(elevation * degree))
      .cast<float>();
}

TEST(EnvironmentRadiance, APatchIsWhereItIsSaidToBe) {
  Environment room;
  room.patches = {{350, 20, 40, 10, {1, 2, 3}}};
  room.softness = 0.5;
  const Eigen::Vector3f middle = EnvironmentRadiance(room, Direction(-10, 20));
  EXPECT_TRUE(middle.isApprox(Eigen::Vector3f(1, 2, 3), 1e-5f));
  // Its upper border; its side, further off in azimuth than at the horizon.
  EXPECT_TRUE(EnvironmentRadiance(room, Direction(350, 24)).isApprox(middle));
  EXPECT_TRUE(
      EnvironmentRadiance(room, Direction(350, 26)).isApprox(room.wall));
  EXPECT_TRUE(EnvironmentRadiance(room, Direction(10, 20)).isApprox(middle));
  EXPECT_TRUE(EnvironmentRadiance(room, Direction(13, 20)).isApprox(room.wall));
  // Not on the other side of the room.
  EXPECT_TRUE(
      EnvironmentRadiance(room, Direction(170, 20)).isApprox(room.wall));
}

TEST(EnvironmentRadiance, SoftnessIsTheWidthOfABorder) {
  Environment room;
  room.patches = {{0, 0, 20, 20, {5, 5, 5}}};
  room.softness = 4;
  const auto at = [&](double azimuth) {
    return EnvironmentRadiance(room, Direction(azimuth, 0)).x();
  };
  EXPECT_NEAR(at(7.9), 5, 1e-3);
  EXPECT_NEAR(at(10), (5 + room.wall.x()) / 2, 1e-2);
  EXPECT_NEAR(at(12.1), room.wall.x(), 1e-3);
}

TEST(EnvironmentRadiance, DoesNotAskForUnitLength) {
  const Environment room = MakeRoom(3, 2);
  const Eigen::Vector3f direction(0.3f, -0.5f, 0.2f);
  EXPECT_TRUE(EnvironmentRadiance(room, direction)
                  .isApprox(EnvironmentRadiance(room, 7 * direction), 1e-4f));
}

TEST(MakeRoom, HasHighContrast) {
  const Environment room = MakeRoom(4, 2);
  float low = 1e9f;
  float high = 0;
  for (int azimuth = 0; azimuth < 360; azimuth += 2) {
    for (int elevation = -88; elevation < 90; elevation += 2) {
      const float green =
          EnvironmentRadiance(room, Direction(azimuth, elevation)).y();
      low = std::min(low, green);
      high = std::max(high, green);
    }
  }
  EXPECT_NEAR(high, 4, 0.01);
  EXPECT_LT(low, 0.02f);
}

TEST(LampLights, GiveADiffuseSurfaceWhatTheRoomGives) {
  Environment room = MakeRoom(10, 0.5);
  room.patches.clear();
  room.wall = room.floor = room.ceiling = Eigen::Vector3f::Zero();
  const std::vector<AreaLight> lights = LampLights(room);
  ASSERT_EQ(lights.size(), room.lamps.size());
  // The integral of radiance times cosine over the room, over pi, of a surface
  // that all lamps are in front of.
  const Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const double step = 0.5;
  const double degree = std::numbers::pi / 180;
  for (double elevation = step / 2; elevation < 90; elevation += step) {
    for (double azimuth = step / 2; azimuth < 360; azimuth += step) {
      const Eigen::Vector3f direction = Direction(azimuth, elevation);
      sum += (EnvironmentRadiance(room, direction) * normal.dot(direction))
                 .cast<double>() *
             step * step * degree * degree * std::cos(elevation * degree);
    }
  }
  Eigen::Vector3d expected = Eigen::Vector3d::Zero();
  for (const AreaLight& light : lights) {
    const Eigen::Vector3f toward = light.direction.normalized().cast<float>();
    expected += (light.color * normal.dot(toward)).cast<double>();
  }
  EXPECT_TRUE((sum / std::numbers::pi).isApprox(expected, 0.05))
      << (sum / std::numbers::pi).transpose() << ", " << expected.transpose();
}

}  // namespace
}  // namespace octacut
