#include "core/benchmark/protocols/middlebury.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/core/benchmark/protocols/protocol_figures.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

IndexedMesh Flat(double x0) {
  IndexedMesh mesh = HeightField(10, [](double, double) { return 0.0; });
  for (Eigen::Vector3d& p : mesh.positions) {
    p.x() += x0;
  }
  return mesh;
}

TEST(Middlebury, AccuracyIsTheDistanceOfNineTenths) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 1; i <= 10; ++i) {
    points.emplace_back(0.5, 0.5, 0.01 * i);
  }
  const ProtocolResult result =
      MeasureMiddlebury(Cloud(points), Flat(0), nullptr, 0.1, Context(2));
  EXPECT_NEAR(Figure(result, "accuracy"), 0.09, 1e-12);
  // The share of the 11 x 11 vertices at 0.1 or less from a point: the height
  // is 0.01 at least, so only the one below the points.
  EXPECT_NEAR(Figure(result, "completeness"), 1.0 / 121, 1e-12);
  EXPECT_EQ(Figure(result, "vertices"), 10);
}

TEST(Middlebury, CompletenessCountsVerticesOfTheReference) {
  IndexedMesh half = KeepTriangles(
      Flat(0), [](const Eigen::Vector3d& p) { return p.x() < 0.5; });
  // Columns of vertices at x = 0, 0.1, ... 1; the half ends at 0.5.
  const ProtocolResult result =
      MeasureMiddlebury(half, Flat(0), nullptr, 0.15, Context(2));
  EXPECT_EQ(Figure(result, "accuracy"), 0);
  EXPECT_NEAR(Figure(result, "completeness"), 7.0 / 11, 1e-12);
}

TEST(Middlebury, VerticesAtFilledHolesDoNotCount) {
  EXPECT_TRUE(NeedsHoleFiller(Flat(0), Context(2)));
  EXPECT_FALSE(NeedsHoleFiller(Cube(3), Context(2)));
  EXPECT_FALSE(NeedsHoleFiller(Cloud({{0, 0, 0}}), Context(2)));
  // Nine points above the ground truth at 0.02, one above its hole at 0.3.
  std::vector<Eigen::Vector3d> points(9, {0.5, 0.5, 0.02});
  points.emplace_back(1.5, 0.5, 0.3);
  points.emplace_back(1.6, 0.5, 0.3);
  const IndexedMesh filler = Flat(1);
  const ProtocolResult with =
      MeasureMiddlebury(Cloud(points), Flat(0), &filler, 0.1, Context(2));
  EXPECT_NEAR(Figure(with, "accuracy"), 0.02, 1e-12);
  EXPECT_EQ(Figure(with, "vertices at holes"), 2);
  const ProtocolResult without =
      MeasureMiddlebury(Cloud(points), Flat(0), nullptr, 0.1, Context(2));
  EXPECT_NEAR(Figure(without, "accuracy"), std::hypot(0.5, 0.3), 1e-12);
  EXPECT_THROW(MeasureMiddlebury(
                   Cloud({{1.5, 0.5, 0}}), Flat(0), &filler, 0.1, Context(2)),
               InputError);
}

}  // namespace
}  // namespace octacut
