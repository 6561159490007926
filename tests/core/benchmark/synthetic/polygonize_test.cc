#include "core/benchmark/synthetic/polygonize.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "tests/core/benchmark/synthetic/mesh_checks.h"

namespace octacut {
namespace {

constexpr double kPi = std::numbers::pi;

PolygonizeOptions Resolution(int resolution) {
  PolygonizeOptions options;
  options.resolution = resolution;
  return options;
}

TEST(Polygonize, SphereHasItsAreaAndVolume) {
  const IndexedMesh mesh =
      Polygonize(MakeSphere(0.8), Resolution(60), Context(2));
  EXPECT_TRUE(IsClosedAndOriented(mesh));
  EXPECT_EQ(Genus(mesh), 0);
  EXPECT_NEAR(Volume(mesh) / (4 / 3.0 * kPi * std::pow(0.8, 3)), 1, 1e-3);
  EXPECT_NEAR(Area(mesh) / (4 * kPi * 0.64), 1, 1e-3);
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    ASSERT_NEAR(mesh.positions[i].norm(), 0.8, 1e-12);
    ASSERT_NEAR(
        mesh.normals[i].cast<double>().dot(mesh.positions[i]), 0.8, 1e-6);
  }
}

TEST(Polygonize, TorusHasItsGenusAreaAndVolume) {
  const IndexedMesh mesh =
      Polygonize(MakeTorus(0.7, 0.25), Resolution(80), Context(2));
  EXPECT_TRUE(IsClosedAndOriented(mesh));
  EXPECT_EQ(Genus(mesh), 1);
  EXPECT_EQ(CountComponents(mesh), 1);
  EXPECT_NEAR(Volume(mesh) / (2 * kPi * kPi * 0.7 * 0.0625), 1, 2e-3);
  EXPECT_NEAR(Area(mesh) / (4 * kPi * kPi * 0.7 * 0.25), 1, 2e-3);
}

TEST(Polygonize, TrianglesAreWellShaped) {
  const IndexedMesh mesh =
      Polygonize(MakeTorus(0.7, 0.25), Resolution(60), Context(2));
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.positions[triangle[0]];
    const Eigen::Vector3d ab = mesh.positions[triangle[1]] - a;
    const Eigen::Vector3d ac = mesh.positions[triangle[2]] - a;
    const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
    EXPECT_GT(ab.cross(ac).norm(), 0.1 * longest * longest);
  }
}

TEST(Polygonize, SeparatePartsStaySeparate) {
  const IndexedMesh mesh =
      Polygonize(Union({MakeSphere(0.3), Move(MakeTorus(0.3, 0.1), {1, 0, 0})}),
                 Resolution(60),
                 Context(2));
  EXPECT_TRUE(IsClosedAndOriented(mesh));
  EXPECT_EQ(CountComponents(mesh), 2);
  EXPECT_EQ(Genus(mesh), 1);
}

TEST(Polygonize, WrongSlopeBoundIsFoundOut) {
  ImplicitShape shape = MakeSphere(0.5);
  shape.lipschitz = 0.2;
  EXPECT_THROW(Polygonize(shape, Resolution(40), Context(1)), Error);
}

TEST(Polygonize, NothingIsNoSurface) {
  ImplicitShape shape = MakeSphere(0.5);
  shape.value = [](const Eigen::Vector3d&) { return 1.0; };
  EXPECT_THROW(Polygonize(shape, Resolution(40), Context(1)), InputError);
}

TEST(PolygonizeOptions, RefusesBadValues) {
  EXPECT_THROW(Resolution(4).Check(), OptionError);
  EXPECT_THROW(Resolution(10000).Check(), OptionError);
  PolygonizeOptions options;
  options.smoothing_rounds = -1;
  EXPECT_THROW(options.Check(), OptionError);
  EXPECT_NO_THROW(PolygonizeOptions{}.Check());
}

}  // namespace
}  // namespace octacut
