#include "core/benchmark/protocols/eth3d.h"

#include <gtest/gtest.h>

#include "tests/core/benchmark/protocols/protocol_figures.h"

namespace octacut {
namespace {

// A scanner at the origin sees a wall at z = 2: points every 5 cm, each alone
// in its cell. Beams have a radius of 1.5 mm there.
LaserScan Wall() {
  LaserScan scan;
  for (int i = -4; i <= 4; ++i) {
    for (int j = -4; j <= 4; ++j) {
      scan.points.emplace_back(0.05 * i + 0.0025, 0.05 * j + 0.0025, 2.0025);
    }
  }
  return scan;
}

TEST(Eth3d, FreeSpaceIsJudgedAndOccludedSpaceIsNot) {
  const LaserScan wall = Wall();
  const std::vector<Eigen::Vector3d>& hits = wall.points;
  const IndexedMesh cloud = Cloud({
      hits[0],                                        // on the wall
      hits[20] * 0.95,                                // in front of it
      hits[40] * 1.05,                                // behind it
      hits[60] + Eigen::Vector3d(0.02, 0, 0),         // between the beams
      -hits[80],                                      // behind the scanner
      hits[10] + Eigen::Vector3d(0.0012, 0, -0.004),  // in the beam
  });
  const ProtocolResult result =
      MeasureEth3d(cloud, {wall}, {0.2, 0.01}, Context(2));
  ASSERT_EQ(result.scores.size(), 2u);
  EXPECT_EQ(result.scores[0].tolerance, 0.01);
  // Two accurate ones, and one in front of the wall.
  EXPECT_NEAR(result.scores[0].precision, 2.0 / 3, 1e-12);
  // At 20 cm those on a beam are accurate, also behind the wall.
  EXPECT_EQ(result.scores[1].precision, 1);
  // Within 1 cm of the cloud are the hits 0 and 10.
  EXPECT_NEAR(result.scores[0].recall, 2.0 / 81, 1e-12);
  EXPECT_EQ(Figure(result, "scan points"), 81);
}

TEST(Eth3d, OneScanThatConfirmsAPointSuffices) {
  const LaserScan wall = Wall();
  // In front of the wall for the first scanner, hit by the second, which stands
  // elsewhere and is turned.
  const Eigen::Vector3d point = wall.points[20] * 0.95;
  LaserScan second;
  second.world_from_scan.rotation =
      Eigen::AngleAxisd(1.2, Eigen::Vector3d::UnitY()).toRotationMatrix();
  second.world_from_scan.translation = {1, 0.3, 0.5};
  second.points = {second.world_from_scan.Inverse() * point};
  const IndexedMesh cloud = Cloud({point});
  EXPECT_EQ(MeasureEth3d(cloud, {wall}, {0.01}, Context(2)).scores[0].precision,
            0);
  EXPECT_EQ(MeasureEth3d(cloud, {wall, second}, {0.01}, Context(2))
                .scores[0]
                .precision,
            1);
  EXPECT_NEAR((MergeScans({wall, second}).back() - point).norm(), 0, 1e-12);
}

TEST(Eth3d, CellsCountNotPoints) {
  const LaserScan wall = Wall();
  // A crowd in front of one beam, in one cell of 1 cm in either grid, and one
  // point on the wall: half of the cells, though a hundredth of the points.
  std::vector<Eigen::Vector3d> points(99, Eigen::Vector3d(0.0025, 0.0025, 0.5));
  LaserScan beam;
  beam.points = {{0.01, 0.01, 2.0}, wall.points[0]};
  for (Eigen::Vector3d& point : points) {
    point = beam.points[0] / 4;
  }
  points.push_back(wall.points[0]);
  const ProtocolResult result =
      MeasureEth3d(Cloud(points), {beam}, {0.01}, Context(2));
  EXPECT_NEAR(result.scores[0].precision, 0.5, 1e-12);
  EXPECT_NEAR(result.scores[0].recall, 0.5, 1e-12);
  EXPECT_NEAR(result.scores[0].f_score, 0.5, 1e-12);
}

}  // namespace
}  // namespace octacut
