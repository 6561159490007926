#include "core/benchmark/protocols/surface_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/benchmark/protocols/point_tree.h"
#include "tests/core/benchmark/protocols/protocol_figures.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(PointTree, ClosestPointsAndNeighbours) {
  const PointTree tree({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(tree.FindClosest({2.6, 0, 0}).index, 2u);
  EXPECT_NEAR(tree.FindClosest({2.6, 0, 0}).distance, 0.4, 1e-15);
  // A point at exactly the radius is within it.
  EXPECT_THAT(tree.FindWithin({0, 0, 0}, 1), ElementsAre(0, 1, 3));
  EXPECT_THAT(tree.FindWithin({-1, 0, 0}, 0.5), ElementsAre());
  EXPECT_THROW(PointTree({}), InputError);
}

TEST(PointsOfSurface, OnePointForEachSquareAndTheVertices) {
  // The unit cube: area 6, 8 vertices.
  EXPECT_EQ(PointsOfSurface(Cube(1), 0.1, 0, Context(2)).size(), 608u);
  EXPECT_EQ(PointsOfSurface(Cloud({{0, 0, 0}}), 0.1, 0, Context(2)).size(), 1u);
  EXPECT_THAT([] { PointsOfSurface(Cube(1), 1e-6, 0, Context(2)); },
              ThrowsMessage<InputError>(HasSubstr("reference's units")));
}

TEST(ThinPoints, LeavesNoTwoPointsCloserAndNoGap) {
  const std::vector<Eigen::Vector3d> points =
      PointsOfSurface(Cube(1), 0.02, 0, Context(2));
  const PointTree thinned(ThinPoints(points, 0.1, 5, Context(2)));
  EXPECT_LT(thinned.Points().size(), points.size() / 10);
  for (const Eigen::Vector3d& p : thinned.Points()) {
    EXPECT_EQ(thinned.FindWithin(p, 0.1).size(), 1u);
  }
  for (const Eigen::Vector3d& p : points) {
    EXPECT_LE(thinned.FindClosest(p).distance, 0.1);
  }
  EXPECT_EQ(ThinPoints(points, 0.1, 5, Context(4)), thinned.Points());
}

TEST(AverageInCells, MeansOfCellsThatBeginHalfACellBelow) {
  // Cells of 1 from -0.5: {0, 0.4}, {0.6}, {2}.
  const std::vector<Eigen::Vector3d> means =
      AverageInCells({{0, 0, 0}, {0.6, 0, 0}, {0.4, 0, 0}, {2, 0, 0}}, 1);
  ASSERT_EQ(means.size(), 3u);
  EXPECT_NEAR(means[0].x(), 0.2, 1e-15);
  EXPECT_NEAR(means[1].x(), 0.6, 1e-15);
  EXPECT_NEAR(means[2].x(), 2, 1e-15);
}

}  // namespace
}  // namespace octacut
