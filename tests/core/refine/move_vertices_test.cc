#include "core/refine/move_vertices.h"

#include <gtest/gtest.h>

#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

using testing::Random;
using testing::RefineScene;

constexpr double kRadius = 0.4;
constexpr double kSpacing = 0.05;

// A sphere with noise and its points, all of which move by the same offset.
struct MovingSphere {
  IndexedMesh mesh;
  SurfacePoints points;
  MovedPoints moved;

  MovingSphere(double noise, double offset) {
    Random random(3);
    mesh = Sphere(40, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return (kRadius + random.Uniform(-noise, noise)) * p;
    });
    mesh.normals = ComputeVertexNormals(mesh, Context(1));
    const VertexCorners neighbors = RefineScene::Neighbors(mesh);
    points = SpreadPoints(mesh, neighbors, kSpacing);
    moved.surfaces =
        FitLocalSurfaces(mesh, neighbors, points.vertices, 0.08, Context(1));
    moved.offsets.assign(points.vertices.size(), offset);
    moved.slopes.assign(points.vertices.size(), Eigen::Vector3f::Zero());
    moved.is_free.assign(points.vertices.size(), 1);
    moved.is_smooth.assign(points.vertices.size(), 1);
  }
  double Move() {
    return MoveVertices(points, moved, 1.5 * kSpacing, Context(2), &mesh);
  }
  double MeanError(double radius) const {
    double sum = 0;
    for (const Eigen::Vector3d& position : mesh.positions) {
      sum += std::abs(position.norm() - radius);
    }
    return sum / double(mesh.positions.size());
  }
};

TEST(MoveVertices, FollowThePointsAroundThem) {
  MovingSphere sphere(0, 0.02);
  EXPECT_NEAR(sphere.Move(), 0.02, 1e-3);
  for (const Eigen::Vector3d& position : sphere.mesh.positions) {
    EXPECT_NEAR(position.norm(), kRadius + 0.02, 1e-3);
  }
}

TEST(MoveVertices, BecomeSmoothWhereTheirPointsAre) {
  MovingSphere sphere(0.004, 0.01);
  const double noise = sphere.MeanError(kRadius);
  ASSERT_GT(noise, 0.0015);
  MovingSphere rough = sphere;
  sphere.Move();
  EXPECT_LT(sphere.MeanError(kRadius + 0.01), noise / 3);
  rough.moved.is_smooth.assign(rough.points.vertices.size(), 0);
  rough.Move();
  EXPECT_NEAR(rough.MeanError(kRadius + 0.01), noise, 0.3 * noise);
}

TEST(MoveVertices, StayWhereTheirPointStays) {
  MovingSphere sphere(0.004, 0.01);
  const std::vector<Eigen::Vector3d> before = sphere.mesh.positions;
  for (size_t i = 0; i < sphere.points.vertices.size(); ++i) {
    sphere.moved.is_free[i] = before[sphere.points.vertices[i]].z() > 0;
  }
  sphere.Move();
  size_t num_moved = 0;
  for (size_t v = 0; v < before.size(); ++v) {
    const bool is_free = sphere.moved.is_free[sphere.points.point_of[v]] != 0;
    EXPECT_EQ(is_free, sphere.mesh.positions[v] != before[v]);
    num_moved += is_free;
  }
  EXPECT_GT(num_moved, before.size() / 3);
  EXPECT_LT(num_moved, before.size() * 2 / 3);
}

}  // namespace
}  // namespace octacut
