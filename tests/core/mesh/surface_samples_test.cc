#include "core/mesh/surface_samples.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

TEST(SampleSurface, EveryTriangleGetsItsShare) {
  const IndexedMesh mesh = Potato(12);
  const size_t count = 50000;
  const std::vector<SurfaceSample> samples =
      SampleSurface(mesh, count, 3, Context(1));
  ASSERT_EQ(samples.size(), count);
  std::vector<double> area(mesh.triangles.size());
  double total = 0;
  for (size_t i = 0; i < area.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    area[i] = 0.5 * (mesh.positions[b] - mesh.positions[a])
                        .cross(mesh.positions[c] - mesh.positions[a])
                        .norm();
    total += area[i];
  }
  std::vector<double> share(area.size());
  for (const SurfaceSample& sample : samples) {
    share[sample.triangle] += total / static_cast<double>(count);
  }
  for (size_t i = 0; i < area.size(); ++i) {
    // Pieces of equal area: at most one piece too many or too few each end.
    EXPECT_NEAR(share[i], area[i], 2 * total / static_cast<double>(count));
  }
}

TEST(SampleSurface, PointsLieInTheirTriangles) {
  const IndexedMesh mesh = Potato(5);
  for (const SurfaceSample& sample : SampleSurface(mesh, 5000, 1, Context(1))) {
    const auto& [a, b, c] = mesh.triangles[sample.triangle];
    Eigen::Matrix3d corners;
    corners << mesh.positions[a], mesh.positions[b], mesh.positions[c];
    const Eigen::Vector3d weights = corners.inverse() * sample.point;
    EXPECT_NEAR(weights.sum(), 1, 1e-12);
    EXPECT_GE(weights.minCoeff(), -1e-12);
  }
}

TEST(SampleSurface, OneLargeTriangleIsCoveredEvenly) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  const size_t count = 16384;
  double sum = 0;
  double sum_of_squares = 0;
  std::array<int, 16> bins = {};
  for (const SurfaceSample& sample :
       SampleSurface(mesh, count, 9, Context(1))) {
    sum += sample.point.x();
    sum_of_squares += sample.point.x() * sample.point.y();
    // The triangle in 16 like parts: squares of its grid, halved.
    const double u = 4 * sample.point.x();
    const double v = 4 * sample.point.y();
    const int column = static_cast<int>(u);
    const int row = static_cast<int>(v);
    const bool upper = u - column + v - row > 1;
    int bin = 0;
    for (int r = 0; r < row; ++r) {
      bin += 2 * (4 - r) - 1;
    }
    ++bins[bin + 2 * column + upper];
  }
  // Far better than the 0.2 % of independent points.
  EXPECT_NEAR(sum / count, 1.0 / 3, 2e-4);
  EXPECT_NEAR(sum_of_squares / count, 1.0 / 12, 2e-4);
  for (const int bin : bins) {
    EXPECT_NEAR(bin, count / 16.0, 20);
  }
}

TEST(SampleSurface, SeedAndThreads) {
  const IndexedMesh mesh = Sphere(9);
  const auto points = [&](uint64_t seed, int threads) {
    std::vector<Eigen::Vector3d> result;
    for (const SurfaceSample& sample :
         SampleSurface(mesh, 30000, seed, Context(threads))) {
      result.push_back(sample.point);
    }
    return result;
  };
  EXPECT_EQ(points(5, 1), points(5, 2));
  EXPECT_EQ(points(5, 1), points(5, 4));
  EXPECT_NE(points(5, 1), points(6, 1));
}

TEST(SampleSurface, TrianglesWithoutAreaGetNothing) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  mesh.triangles = {{0, 0, 0}, {0, 1, 3}, {0, 1, 2}, {1, 1, 2}, {3, 1, 0}};
  for (const SurfaceSample& sample : SampleSurface(mesh, 1000, 0, Context(1))) {
    EXPECT_EQ(sample.triangle, 2u);
  }
}

TEST(SampleSurface, NoAreaIsAnError) {
  IndexedMesh mesh;
  EXPECT_THROW(SampleSurface(mesh, 10, 0, Context(1)), InputError);
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {NAN, 1, 0}};
  mesh.triangles = {{0, 1, 1}};
  EXPECT_THROW(SampleSurface(mesh, 10, 0, Context(1)), InputError);
  mesh.triangles = {{0, 1, 2}};
  EXPECT_THROW(SampleSurface(mesh, 10, 0, Context(1)), InputError);
}

}  // namespace
}  // namespace octacut
