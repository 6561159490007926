#include "core/benchmark/protocols/dtu.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/core/benchmark/protocols/protocol_figures.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// Points every millimetre on [0, 40]^2 at a height.
std::vector<Eigen::Vector3d> Lattice(double height) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= 40; ++i) {
    for (int j = 0; j <= 40; ++j) {
      points.emplace_back(i, j, height);
    }
  }
  return points;
}

// All of [-50, 60]^3 is observed.
ObservabilityMask Mask() {
  ObservabilityMask mask;
  mask.size = {12, 12, 12};
  mask.cells.assign(12 * 12 * 12, 1);
  mask.box_min = Eigen::Vector3d::Constant(-50);
  mask.box_max = Eigen::Vector3d::Constant(60);
  mask.cell_size = 10;
  return mask;
}

const Eigen::Vector4d kFloor(0, 0, 1, 10);  // z > -10

TEST(Dtu, ParallelPlanesAndAWrongPart) {
  std::vector<Eigen::Vector3d> data = Lattice(0.5);
  for (Eigen::Vector3d& point : data) {
    point.z() = point.x() > 30.5 ? 3 : 0.5;
  }
  const ProtocolResult result =
      MeasureDtu(Cloud(data), Cloud(Lattice(0)), Mask(), kFloor, Context(2));
  // 10 of 41 columns are 3 mm off.
  const double mean = (31 * 0.5 + 10 * 3) / 41;
  EXPECT_NEAR(Figure(result, "accuracy"), mean, 1e-12);
  EXPECT_NEAR(Figure(result, "accuracy median"), 0.5, 1e-12);
  // The reference below them is closest to the columns at 0.5 mm where these
  // are 1 or 2 mm aside.
  const double back =
      (31 * 0.5 + std::hypot(1, 0.5) + std::hypot(2, 0.5) + 8 * 3) / 41;
  EXPECT_NEAR(Figure(result, "completeness"), back, 1e-12);
  EXPECT_NEAR(Figure(result, "overall"), (mean + back) / 2, 1e-12);
  EXPECT_EQ(Figure(result, "points"), 41 * 41);
}

TEST(Dtu, WhatIsThinnedCroppedOrAnOutlierDoesNotCount) {
  std::vector<Eigen::Vector3d> data = Lattice(0.5);
  // Copies of a bad point, which thinning makes one again.
  for (int i = 0; i < 500; ++i) {
    data.emplace_back(20.5, 20.5, 10 + 1e-4 * i);
  }
  const ProtocolResult thinned =
      MeasureDtu(Cloud(data), Cloud(Lattice(0)), Mask(), kFloor, Context(2));
  EXPECT_NEAR(Figure(thinned, "points"), 41 * 41 + 1, 0);
  data.resize(41 * 41);
  // 25 mm away; outside of the box; in a cell that is not observed.
  data.emplace_back(20, 20, 25);
  data.emplace_back(20, 20, -70);
  data.emplace_back(20, 20, -15);
  ObservabilityMask mask = Mask();
  // The cell of x, y in [15, 25), z in [-15, -5).
  mask.cells[7 + 12 * (7 + 12 * 4)] = 0;
  EXPECT_FALSE(mask.Contains({20, 20, -14}));
  EXPECT_TRUE(mask.Contains({20, 20, -4}));
  EXPECT_TRUE(mask.Contains({20, 26, -14}));
  std::vector<Eigen::Vector3d> truth = Lattice(0);
  truth.emplace_back(10, 10, -12);  // below the floor
  data.back().z() = -14;
  const ProtocolResult result =
      MeasureDtu(Cloud(data), Cloud(truth), mask, kFloor, Context(2));
  EXPECT_NEAR(Figure(result, "accuracy"), 0.5, 1e-12);
  EXPECT_NEAR(Figure(result, "completeness"), 0.5, 1e-12);
  EXPECT_EQ(Figure(result, "points"), 41 * 41);
  EXPECT_EQ(Figure(result, "reference points"), 41 * 41);
}

TEST(Dtu, NothingThatCountsIsAnError) {
  ObservabilityMask mask = Mask();
  mask.cells.assign(mask.cells.size(), 0);
  EXPECT_THAT(
      [&] {
        MeasureDtu(
            Cloud(Lattice(0)), Cloud(Lattice(0)), mask, kFloor, Context(2));
      },
      ThrowsMessage<InputError>(HasSubstr("no point of the mesh counts")));
  EXPECT_THAT(
      [&] {
        MeasureDtu(Cloud(Lattice(0)),
                   Cloud(Lattice(0)),
                   Mask(),
                   Eigen::Vector4d(0, 0, 1, -5),
                   Context(2));
      },
      ThrowsMessage<InputError>(HasSubstr("no point of the reference counts")));
}

}  // namespace
}  // namespace octacut
