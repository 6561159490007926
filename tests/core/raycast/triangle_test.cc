#include "core/raycast/triangle.h"

#include <gtest/gtest.h>

#include "tests/core/raycast/random_mesh.h"

namespace octacut {
namespace {

// The nearest of a fine lattice of the triangle's points.
double SampledDistance(const Eigen::Vector3d& query,
                       const Eigen::Vector3d& a,
                       const Eigen::Vector3d& b,
                       const Eigen::Vector3d& c,
                       int steps) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const double u = double(i) / steps;
      const double v = double(j) / steps;
      const Eigen::Vector3d point = a + u * (b - a) + v * (c - a);
      best = std::min(best, (point - query).norm());
    }
  }
  return best;
}

TEST(ClosestPointOnTriangle, IsNearestOfAllPoints) {
  std::mt19937 rng(1);
  for (int trial = 0; trial < 300; ++trial) {
    const Eigen::Vector3d a = RandomPoint(rng, 1);
    const Eigen::Vector3d b = RandomPoint(rng, 1);
    const Eigen::Vector3d c = RandomPoint(rng, 1);
    const Eigen::Vector3d query = RandomPoint(rng, 2);
    const Eigen::Vector3d point = ClosestPointOnTriangle(query, a, b, c);
    const int steps = 60;
    const double sampled = SampledDistance(query, a, b, c, steps);
    const double distance = (point - query).norm();
    EXPECT_LE(distance, sampled + 1e-12);
    EXPECT_GE(distance, sampled - 4.0 / steps);
    // The point is on the triangle itself.
    EXPECT_LT((ClosestPointOnTriangle(point, a, b, c) - point).norm(), 1e-12);
  }
}

TEST(ClosestPointOnTriangle, KnowsFaceEdgeAndCorner) {
  const Eigen::Vector3d a(0, 0, 0);
  const Eigen::Vector3d b(1, 0, 0);
  const Eigen::Vector3d c(0, 1, 0);
  const auto closest = [&](double x, double y, double z) {
    return ClosestPointOnTriangle({x, y, z}, a, b, c);
  };
  EXPECT_LT((closest(0.2, 0.3, 5) - Eigen::Vector3d(0.2, 0.3, 0)).norm(),
            1e-15);
  EXPECT_LT((closest(0.4, -2, -1) - Eigen::Vector3d(0.4, 0, 0)).norm(), 1e-15);
  EXPECT_LT((closest(1, 1, 3) - Eigen::Vector3d(0.5, 0.5, 0)).norm(), 1e-15);
  EXPECT_EQ(closest(-1, -2, 3), a);
  EXPECT_EQ(closest(4, -1, 3), b);
  EXPECT_EQ(closest(-1, 7, 3), c);
}

TEST(ClosestPointOnTriangle, TakesTrianglesWithoutArea) {
  const Eigen::Vector3d a(0, 0, 0);
  const Eigen::Vector3d b(2, 0, 0);
  const Eigen::Vector3d c(1, 0, 0);
  const Eigen::Vector3d query(1.5, 1, 0);
  const Eigen::Vector3d foot(1.5, 0, 0);
  EXPECT_LT((ClosestPointOnTriangle(query, a, b, c) - foot).norm(), 1e-15);
  EXPECT_LT((ClosestPointOnTriangle(query, a, c, b) - foot).norm(), 1e-15);
  EXPECT_EQ(ClosestPointOnTriangle(query, c, c, c), c);
}

}  // namespace
}  // namespace octacut
