#include "core/refine/keep_valid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/audit.h"
#include "core/mesh/self_intersections.h"
#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

constexpr double kPixel = 0.01;

size_t Keep(const ViewSet& views,
            const std::vector<Eigen::Vector3d>& start,
            const std::vector<Eigen::Vector3d>& before,
            double tolerance,
            double pixel,
            IndexedMesh* mesh) {
  return KeepValid(views,
                   testing::RefineScene::Neighbors(*mesh),
                   {start, before, tolerance, pixel},
                   Context(2),
                   mesh);
}

TEST(KeepValid, LeavesAlonePlainMoves) {
  const IndexedMesh start = Sphere(12, 0.4);
  IndexedMesh mesh = Sphere(12, 0.41);
  const std::vector<Eigen::Vector3d> moved = mesh.positions;
  EXPECT_EQ(Keep({}, start.positions, start.positions, 1, kPixel, &mesh), 0u);
  EXPECT_EQ(mesh.positions, moved);
}

TEST(KeepValid, TakesBackWhatIntersects) {
  const IndexedMesh start = Sphere(12, 0.4);
  IndexedMesh mesh = start;
  // Spikes through the other side.
  for (const size_t vertex : {size_t{3}, size_t{200}, size_t{500}}) {
    mesh.positions[vertex] *= -1.5;
  }
  ASSERT_GT(FindSelfIntersections(mesh, Context(2)).num_pairs, 0u);
  EXPECT_GT(Keep({}, start.positions, start.positions, 1, kPixel, &mesh), 0u);
  EXPECT_EQ(FindSelfIntersections(mesh, Context(2)).num_pairs, 0u);
  EXPECT_EQ(AuditMesh(mesh, Context(1)).DescribeFailure(), "");
}

TEST(KeepValid, LeavesIntersectionsThatWereThere) {
  // Two spheres that run through each other from the first.
  IndexedMesh start =
      Joined(Sphere(8, 0.3), Moved(Sphere(8, 0.3), {0.2, 0.05, 0.01}));
  const size_t num_pairs = FindSelfIntersections(start, Context(2)).num_pairs;
  ASSERT_GT(num_pairs, 0u);
  IndexedMesh mesh = start;
  for (Eigen::Vector3d& position : mesh.positions) {
    position *= 1.001;
    position.x() += 0.001 * std::sin(30 * position.y());
  }
  Keep({}, start.positions, start.positions, 1, kPixel, &mesh);
  EXPECT_LE(FindSelfIntersections(mesh, Context(2)).num_pairs, num_pairs);
}

TEST(KeepValid, TakesBackWhatSqueezesTriangles) {
  const IndexedMesh start = Sphere(12, 0.4);
  IndexedMesh mesh = start;
  const auto& [a, b, c] = mesh.triangles[77];
  mesh.positions[a] =
      (0.5 + 1e-9) * mesh.positions[b] + (0.5 - 1e-9) * mesh.positions[c];
  EXPECT_GT(Keep({}, start.positions, start.positions, 1, kPixel, &mesh), 0u);
  const MeshAudit audit = AuditMesh(mesh, Context(1));
  EXPECT_EQ(audit.num_degenerate_triangles, 0u);
}

TEST(KeepValid, SmoothsWhatIsLeftBehind) {
  const IndexedMesh start = Sphere(24, 0.4);
  IndexedMesh mesh = Sphere(24, 0.45);
  const auto& [a, b, c] = mesh.triangles[77];
  const std::vector<Eigen::Vector3d> moved = mesh.positions;
  mesh.positions[a] =
      (0.5 + 1e-9) * mesh.positions[b] + (0.5 - 1e-9) * mesh.positions[c];
  EXPECT_GT(Keep({}, start.positions, start.positions, 1, kPixel, &mesh), 0u);
  size_t num_changed = 0;
  for (size_t v = 0; v < moved.size(); ++v) {
    // A third of what it is behind.
    EXPECT_NEAR(mesh.positions[v].norm(), moved[v].norm(), 0.05 / 3);
    num_changed += mesh.positions[v] != moved[v] ? 1 : 0;
  }
  EXPECT_LT(num_changed, moved.size() / 10);
}

TEST(KeepValid, KeepsVerticesInTheHull) {
  const testing::RefineScene scene = testing::MakeRefineScene();
  const IndexedMesh start = scene.Larger(24, -1);
  IndexedMesh mesh = scene.Larger(24, 7);
  const double pixel = scene.Pixel() / scene.test.region.cube.edge;
  EXPECT_GT(Keep(scene.test.views,
                 start.positions,
                 start.positions,
                 1.5,
                 pixel,
                 &mesh),
            mesh.positions.size() / 2);
  double largest = 0;
  for (const Eigen::Vector3d& position : mesh.positions) {
    largest =
        std::max(largest,
                 testing::ToWorld(scene.test.region.cube, position).norm() -
                     testing::RefineScene::kRadius);
  }
  // The tolerance, and what the masks round to whole pixels.
  EXPECT_LT(largest, 2 * scene.Pixel());
}

// What a first move took into a mask that is too small may come out again.
TEST(KeepValid, AsksTheFirstStartWhatWasOutOfTheHull) {
  const testing::RefineScene scene = testing::MakeRefineScene();
  const double pixel = scene.Pixel() / scene.test.region.cube.edge;
  const IndexedMesh start = scene.Larger(24, 6);
  const IndexedMesh before = scene.Larger(24, -1);
  IndexedMesh mesh = scene.Larger(24, 5);
  const auto keep_valid = [&](const IndexedMesh& first) {
    return Keep(
        scene.test.views, first.positions, before.positions, 1, pixel, &mesh);
  };
  EXPECT_LT(keep_valid(start), mesh.positions.size() / 20);
  EXPECT_GT(keep_valid(before), mesh.positions.size() / 2);
}

// What an earlier move with a larger tolerance took out must not go farther.
TEST(KeepValid, KeepsWhatIsOutOfTheHullFromGoingFarther) {
  const testing::RefineScene scene = testing::MakeRefineScene();
  const IndexedMesh before = scene.Larger(24, 4);
  IndexedMesh mesh = scene.Larger(24, 8);
  EXPECT_GT(Keep(scene.test.views,
                 scene.Larger(24, -1).positions,
                 before.positions,
                 1.5,
                 scene.Pixel() / scene.test.region.cube.edge,
                 &mesh),
            mesh.positions.size() / 2);
}

// What an earlier move with a larger tolerance took out may come nearer.
TEST(KeepValid, LetsComeNearerWhatIsOutOfTheHull) {
  const testing::RefineScene scene = testing::MakeRefineScene();
  IndexedMesh mesh = scene.Larger(24, 4);
  const std::vector<Eigen::Vector3d> moved = mesh.positions;
  EXPECT_EQ(Keep(scene.test.views,
                 scene.Larger(24, -1).positions,
                 scene.Larger(24, 6).positions,
                 1.5,
                 scene.Pixel() / scene.test.region.cube.edge,
                 &mesh),
            0u);
  EXPECT_EQ(mesh.positions, moved);
}

}  // namespace
}  // namespace octacut
