#include "core/print/overhangs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/core/print/print_shapes.h"

namespace octacut {
namespace {

TEST(MeasureOverhangs, SphereHasACap) {
  for (const double angle : {30.0, 45.0, 60.0}) {
    const Overhangs result =
        MeasureOverhangs(Sphere(60), Eigen::Vector3d(1, 2, -3), angle);
    // The share of a cap that reaches 90 - angle degrees from the lowest point.
    const double share = (1 - std::sin(angle * std::numbers::pi / 180)) / 2;
    EXPECT_NEAR(result.share + result.base_area / (4 * std::numbers::pi),
                share,
                0.01 * share);
    EXPECT_NEAR(result.base_area / (4 * std::numbers::pi), 0.001, 0.001);
  }
}

TEST(MeasureOverhangs, WhatRestsOnThePlateIsNone) {
  const Overhangs standing =
      MeasureOverhangs(Cube(4), Eigen::Vector3d::UnitZ(), 45);
  EXPECT_EQ(standing.area, 0);
  EXPECT_NEAR(standing.base_area, 1, 1e-12);
  // On an edge: two sides at exactly 45 degrees need support from 44 on.
  const Eigen::Vector3d edge_up(0, 1, 1);
  EXPECT_NEAR(MeasureOverhangs(Cube(4), edge_up, 44).share, 1.0 / 3, 1e-9);
  EXPECT_EQ(MeasureOverhangs(Cube(4), edge_up, 46).share, 0);
}

TEST(MeasureOverhangs, TheLengthOfUpDoesNotMatter) {
  const Eigen::Vector3d up(0, 1, 1);
  const double share = MeasureOverhangs(Cube(4), up, 44).share;
  for (const double length : {1e-200, 1e200}) {
    EXPECT_NEAR(MeasureOverhangs(Cube(4), length * up, 44).share, share, 1e-9);
  }
}

// The ceiling of a cavity hangs over; its floor does not.
TEST(MeasureOverhangs, CeilingsHangOver) {
  const Overhangs result =
      MeasureOverhangs(BoxWithWall(4, 0.2), Eigen::Vector3d::UnitZ(), 45);
  EXPECT_NEAR(result.area, 0.36, 1e-9);
  EXPECT_NEAR(result.share, 0.36 / (6 + 6 * 0.36), 1e-9);
}

}  // namespace
}  // namespace octacut
