#include "core/print/wall_thickness.h"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "core/base/error.h"
#include "core/mesh/audit.h"
#include "tests/core/print/print_shapes.h"

namespace octacut {
namespace {

constexpr double kHalfTurn = std::numbers::pi;

WallThicknessOptions Options(double min_wall = 0) {
  WallThicknessOptions options;
  options.num_samples = 20000;
  options.min_wall = min_wall;
  return options;
}

WallThickness Measure(const IndexedMesh& mesh, double min_wall = 0) {
  return MeasureWallThickness(mesh, Options(min_wall), Context(1));
}

void ExpectAreaAndVolume(const IndexedMesh& mesh, double area, double volume) {
  const MeshAudit audit = AuditMesh(mesh, Context(1));
  EXPECT_NEAR(audit.area, area, 0.01 * area);
  EXPECT_NEAR(audit.volume, volume, 0.01 * volume);
}

TEST(MeasureWallThickness, Sphere) {
  const double radius = 3;
  const IndexedMesh mesh = Sphere(40, radius);
  ExpectAreaAndVolume(mesh,
                      4 * kHalfTurn * radius * radius,
                      4 * kHalfTurn / 3 * radius * radius * radius);
  const WallThickness walls = Measure(mesh);
  EXPECT_NEAR(walls.min, 2 * radius, 0.01 * 2 * radius);
  EXPECT_NEAR(walls.median, 2 * radius, 0.01 * 2 * radius);
  EXPECT_NEAR(walls.max, 2 * radius, 0.01 * 2 * radius);
  EXPECT_GT(walls.measured_share, 0.999);
  EXPECT_GT(walls.histogram.back(), 0.999);
}

TEST(MeasureWallThickness, Torus) {
  const double ring = 2;
  const double tube = 0.4;
  const IndexedMesh mesh = Torus(80, ring, tube);
  ExpectAreaAndVolume(mesh,
                      4 * kHalfTurn * kHalfTurn * ring * tube,
                      2 * kHalfTurn * kHalfTurn * ring * tube * tube);
  const WallThickness walls = Measure(mesh);
  EXPECT_NEAR(walls.min, 2 * tube, 0.01 * 2 * tube);
  EXPECT_NEAR(walls.percentile_5, 2 * tube, 0.01 * 2 * tube);
  EXPECT_NEAR(walls.median, 2 * tube, 0.01 * 2 * tube);
}

// Walls are `wall` thick under the cavity's sides and 1 beside them.
TEST(MeasureWallThickness, BoxWithAWall) {
  const double wall = 0.1;
  const double side = 1 - 2 * wall;
  const IndexedMesh mesh = BoxWithWall(3, wall);
  ExpectAreaAndVolume(mesh, 6 + 6 * side * side, 1 - side * side * side);
  const WallThickness walls = Measure(mesh, 1.01 * wall);
  EXPECT_NEAR(walls.min, wall, 0.01 * wall);
  EXPECT_NEAR(walls.median, wall, 0.01 * wall);
  EXPECT_NEAR(walls.max, 1, 0.01);
  EXPECT_NEAR(walls.measured_share, 1, 1e-3);
  const double thin_share = 2 * side * side / (1 + side * side);
  EXPECT_NEAR(walls.thin_share, thin_share, 0.01 * thin_share);
  EXPECT_EQ(Measure(mesh, 0.99 * wall).thin_share, 0);
  // Bins of 0.05: the wall is on the border of the second and the third.
  EXPECT_NEAR(walls.histogram[1] + walls.histogram[2], thin_share, 0.01);
  EXPECT_NEAR(walls.histogram.back(), 1 - thin_share, 0.01);
  EXPECT_NEAR(
      std::accumulate(walls.histogram.begin(), walls.histogram.end(), 0.0),
      1,
      1e-9);
}

TEST(MeasureWallThickness, ThinnestPlacesHaveCoordinates) {
  // A dumbbell whose waist at x = 0 is the thinnest part.
  IndexedMesh mesh = Sphere(40);
  for (Eigen::Vector3d& position : mesh.positions) {
    const double waist = 0.4 + 1.2 * position.x() * position.x();
    position = position.cwiseProduct(Eigen::Vector3d(2, waist, waist)).eval();
  }
  const WallThickness walls = Measure(mesh);
  ASSERT_FALSE(walls.thinnest.empty());
  const ThinPlace& first = walls.thinnest.front();
  EXPECT_NEAR(first.thickness, 0.8, 0.02);
  EXPECT_NEAR(first.point.x(), 0, 0.15);
  EXPECT_NEAR(first.point.tail<2>().norm(), 0.4, 0.02);
  for (size_t i = 1; i < walls.thinnest.size(); ++i) {
    EXPECT_GE(walls.thinnest[i].thickness, walls.thinnest[i - 1].thickness);
    for (size_t j = 0; j < i; ++j) {
      EXPECT_GT((walls.thinnest[i].point - walls.thinnest[j].point).norm(),
                0.2);
    }
  }
}

TEST(MeasureWallThickness, SharpEdgesAreNotThinWalls) {
  // Two faces of a roof of 60 degrees see each other at 60 degrees only.
  IndexedMesh roof = Cube(20);
  for (Eigen::Vector3d& position : roof.positions) {
    position.x() = (position.x() - 0.5) * (1 - position.z()) * 1.1547;
  }
  std::erase_if(roof.triangles, [&](const auto& t) {
    return (roof.positions[t[1]] - roof.positions[t[0]])
               .cross(roof.positions[t[2]] - roof.positions[t[0]])
               .norm() < 1e-12;
  });
  EXPECT_GT(Measure(roof).min, 0.2);
}

TEST(MeasureWallThickness, SameForAnyNumberOfThreads) {
  const IndexedMesh mesh = Potato(20);
  const WallThickness one = MeasureWallThickness(mesh, Options(), Context(1));
  const WallThickness four = MeasureWallThickness(mesh, Options(), Context(4));
  EXPECT_EQ(one.histogram, four.histogram);
  EXPECT_EQ(one.median, four.median);
  EXPECT_EQ(one.thinnest.front().point, four.thinnest.front().point);
}

TEST(MeasureWallThickness, OneSkinHasNone) {
  const IndexedMesh skin = HeightField(2, [](double, double) { return 0.0; });
  const WallThickness walls = MeasureWallThickness(skin, {}, Context(2));
  EXPECT_EQ(walls.measured_share, 0);
  EXPECT_TRUE(walls.thinnest.empty());
}

TEST(MeasureWallThickness, NeedsASurface) {
  EXPECT_THROW(Measure(IndexedMesh()), InputError);
}

}  // namespace
}  // namespace octacut
