#include "core/benchmark/protocols/metro.h"

#include <gtest/gtest.h>

#include "tests/core/benchmark/protocols/protocol_figures.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

IndexedMesh SquareAt(double height, double width) {
  IndexedMesh mesh = HeightField(20, [&](double, double) { return height; });
  for (Eigen::Vector3d& p : mesh.positions) {
    p.x() *= width;
  }
  return mesh;
}

TEST(Metro, ParallelSquaresAreTheirDistanceApart) {
  const ProtocolResult result =
      MeasureMetro(SquareAt(0.25, 1), SquareAt(0, 1), Context(2));
  for (const char* name : {"forward mean",
                           "forward rms",
                           "forward max",
                           "backward mean",
                           "backward rms",
                           "backward max",
                           "Hausdorff"}) {
    EXPECT_NEAR(Figure(result, name), 0.25, 1e-12) << name;
  }
  // 800 triangles on each side.
  EXPECT_EQ(Figure(result, "samples"), 16000);
}

TEST(Metro, HalfASquare) {
  const ProtocolResult result =
      MeasureMetro(SquareAt(0, 0.5), SquareAt(0, 1), Context(2));
  EXPECT_NEAR(Figure(result, "forward max"), 0, 1e-12);
  // The integral of x over [0, 0.5], and of its square.
  EXPECT_NEAR(Figure(result, "backward mean"), 0.125, 1e-3);
  EXPECT_NEAR(Figure(result, "backward rms"), std::sqrt(1.0 / 24), 1e-3);
  EXPECT_NEAR(Figure(result, "backward max"), 0.5, 1e-12);
  EXPECT_EQ(Figure(result, "Hausdorff"), Figure(result, "backward max"));
}

TEST(Metro, PointsOfACloudAreTheSamples) {
  const ProtocolResult result = MeasureMetro(
      Cloud({{0.5, 0.5, 0.1}, {0.5, 0.5, -0.3}}), SquareAt(0, 1), Context(2));
  EXPECT_NEAR(Figure(result, "forward mean"), 0.2, 1e-12);
  EXPECT_NEAR(Figure(result, "forward rms"), std::sqrt(0.05), 1e-12);
  EXPECT_NEAR(Figure(result, "forward max"), 0.3, 1e-12);
}

TEST(Metro, SameForAnyNumberOfThreads) {
  const IndexedMesh sphere = Sphere(12, 1.0);
  const IndexedMesh cube = Cube(5);
  const ProtocolResult one = MeasureMetro(sphere, cube, Context(1));
  const ProtocolResult four = MeasureMetro(sphere, cube, Context(4));
  for (size_t i = 0; i < one.figures.size(); ++i) {
    EXPECT_EQ(one.figures[i].value, four.figures[i].value);
  }
}

}  // namespace
}  // namespace octacut
