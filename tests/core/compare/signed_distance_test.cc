#include "core/compare/signed_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/compare/distance_curve.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

TEST(SignedDistances, AroundACube) {
  const IndexedMesh cube = Cube(3);
  const double third = 1 / std::sqrt(3.0);
  const std::vector<float> distances =
      SignedDistances({{0.5, 0.5, 1.25},                   // above a face
                       {0.5, 0.5, 0.75},                   // inside
                       {1.2, 1.2, 0.4},                    // beside an edge
                       {1 + third, 1 + third, 1 + third},  // off a corner
                       {1 - 0.1, 1 - 0.2, 1 - 0.3}},       // inside a corner
                      cube,
                      RayScene(cube),
                      Context(2));
  EXPECT_NEAR(distances[0], 0.25, 1e-6);
  EXPECT_NEAR(distances[1], -0.25, 1e-6);
  EXPECT_NEAR(distances[2], std::sqrt(0.08), 1e-6);
  EXPECT_NEAR(distances[3], 1, 1e-6);
  EXPECT_NEAR(distances[4], -0.1, 1e-6);
}

TEST(SignedDistances, OnlyWhatTheFilterCounts) {
  const IndexedMesh cube = Cube(2);
  const ReferenceFilter upper = [](uint32_t, const Eigen::Vector3d& point) {
    return point.z() > 0.5;
  };
  const std::vector<float> distances = SignedDistances(
      {{0.3, 0.3, 2}, {0.3, 0.3, -1}}, cube, RayScene(cube), Context(2), upper);
  EXPECT_EQ(distances[0], 1);
  EXPECT_TRUE(std::isnan(distances[1]));
  std::vector<float> values(cube.positions.size(), 7);
  DropUnjudged(cube, upper, &values);
  for (size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(std::isnan(values[i]), cube.positions[i].z() <= 0.5);
  }
}

TEST(DistanceCurve, CountsUpToEachThreshold) {
  EXPECT_NEAR(CurveThreshold(0), 1e-6, 1e-18);
  EXPECT_NEAR(CurveThreshold(3 * kCurveStepsPerDecade), 1e-3, 1e-15);
  EXPECT_EQ(CurveThreshold(kCurveSize - 1), 1);
  // Diagonal 2: thresholds are doubled.
  const std::vector<double> curve = DistanceCurve({1e-4, 1e-3, 0.5, 3}, 2);
  EXPECT_EQ(curve.front(), 0);
  EXPECT_EQ(curve[2 * kCurveStepsPerDecade], 0.25);  // 2e-4
  EXPECT_EQ(curve[3 * kCurveStepsPerDecade], 0.5);   // 2e-3
  EXPECT_EQ(curve.back(), 0.75);                     // 2
}

}  // namespace
}  // namespace octacut
