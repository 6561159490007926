#include "core/views/line_of_sight.h"

#include <gtest/gtest.h>

namespace octacut {
namespace {

TEST(PointsOnLine, AreThoseInTheCubeTheNearestFirst) {
  const Eigen::Vector3f center(0.5f, 0.5f, -2);
  const std::vector<Eigen::Vector3f> points =
      PointsOnLine(center, Eigen::Vector3f::UnitZ(), 16);
  ASSERT_EQ(points.size(), 17u);  // both ends are in the cube
  EXPECT_NEAR(points.front().z(), 0, 1e-6);
  EXPECT_NEAR(points.back().z(), 1, 1e-6);
  for (size_t i = 1; i < points.size(); ++i) {
    EXPECT_NEAR((points[i] - points[i - 1]).z(), 1.0f / 16, 1e-6);
  }
}

TEST(PointsOnLine, ReachTheCorners) {
  const Eigen::Vector3f direction = Eigen::Vector3f::Ones().normalized();
  const std::vector<Eigen::Vector3f> points =
      PointsOnLine(-direction, direction, 128);
  EXPECT_LT(points.front().norm(), 1.0f / 128);
  EXPECT_LT((points.back() - Eigen::Vector3f::Ones()).norm(), 1.0f / 128);
}

TEST(PointsOnLine, LieBeforeTheCameraAlone) {
  const Eigen::Vector3f center(0.5f, 0.5f, 0.5f);
  for (const Eigen::Vector3f& point :
       PointsOnLine(center, Eigen::Vector3f::UnitX(), 16)) {
    EXPECT_GT(point.x(), 0.5f);
  }
  EXPECT_TRUE(
      PointsOnLine({0.5f, 0.5f, 2}, Eigen::Vector3f::UnitZ(), 16).empty());
  EXPECT_TRUE(
      PointsOnLine({3, 0.5f, -2}, Eigen::Vector3f::UnitZ(), 16).empty());
}

}  // namespace
}  // namespace octacut
