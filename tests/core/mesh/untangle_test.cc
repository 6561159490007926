#include "core/mesh/untangle.h"

#include <gtest/gtest.h>

#include <random>

#include "core/mesh/place_vertices.h"
#include "core/mesh/smooth.h"
#include "tests/core/mesh/label_crust.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

TEST(Untangle, LeavesAloneWhatDoesNotIntersect) {
  const IndexedMesh start = Sphere(12, 0.4);
  IndexedMesh mesh = Sphere(12, 0.41);
  const std::vector<Eigen::Vector3d> moved = mesh.positions;
  EXPECT_EQ(Untangle(start.positions, 1e-4, Context(2), &mesh), 0u);
  EXPECT_EQ(mesh.positions, moved);
}

TEST(Untangle, TakesBackSpikesThroughTheOtherSide) {
  const IndexedMesh start = Sphere(12, 0.4);
  IndexedMesh mesh = start;
  for (const size_t vertex : {size_t{3}, size_t{200}, size_t{500}}) {
    mesh.positions[vertex] *= -1.5;
  }
  ASSERT_GT(NumIntersections(mesh), 0u);
  EXPECT_GE(Untangle(start.positions, 1e-4, Context(2), &mesh), 3u);
  EXPECT_EQ(NumIntersections(mesh), 0u);
}

// Voxels at random: placed and smoothed, thin walls run through each other.
TEST(Untangle, LeavesRandomBlocksWithoutIntersections) {
  std::mt19937 random(7);
  size_t num_placed = 0;
  size_t num_smoothed = 0;
  for (int round = 0; round < 400; ++round) {
    const LabelledCrust block =
        LabelRandomBlock(2 + round % 4, round % 2 != 0, random);
    PlacedSurface placed = Place(block, UnitVoxels(4));
    if (placed.mesh.triangles.empty()) {
      continue;
    }
    num_placed += NumIntersections(placed.mesh) > 0 ? 1 : 0;
    Untangle(placed.corners, 0.02, Context(2), &placed.mesh);
    EXPECT_EQ(NumIntersections(placed.mesh), 0u) << round;
    SmoothedSurface smoothed =
        SmoothSurface(placed.mesh, 1, SmoothOptions(), Context(1));
    num_smoothed += NumIntersections(smoothed.mesh) > 0 ? 1 : 0;
    Untangle(placed.mesh.positions, 0.02, Context(2), &smoothed.mesh);
    EXPECT_EQ(NumIntersections(smoothed.mesh), 0u) << round;
    ExpectClosedManifold(AuditMesh(smoothed.mesh));
  }
  EXPECT_GT(num_placed, 0u);
  EXPECT_GT(num_smoothed, 0u);
}

}  // namespace
}  // namespace octacut
