#include "core/mesh/untangle.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/extract/label_crust.h"
#include "tests/core/mesh/simple_meshes.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

TEST(Untangle, LeavesAloneWhatDoesNotIntersect) {
  const IndexedMesh start = Sphere(12, 0.4);
  IndexedMesh mesh = Sphere(12, 0.41);
  const std::vector<Eigen::Vector3d> moved = mesh.positions;
  EXPECT_EQ(Untangle(start.positions, 1e-4, Context(2), &mesh).num_withdrawn,
            0u);
  EXPECT_EQ(mesh.positions, moved);
}

TEST(Untangle, TakesBackSpikesThroughTheOtherSide) {
  const IndexedMesh start = Sphere(12, 0.4);
  IndexedMesh mesh = start;
  for (const size_t vertex : {size_t{3}, size_t{200}, size_t{500}}) {
    mesh.positions[vertex] *= -1.5;
  }
  ASSERT_GT(NumIntersections(mesh), 0u);
  EXPECT_GE(Untangle(start.positions, 1e-4, Context(2), &mesh).num_withdrawn,
            3u);
  EXPECT_EQ(NumIntersections(mesh), 0u);
}

TEST(Untangle, ReportsTrianglesThatWereThinFromTheFirst) {
  IndexedMesh mesh = MakeTetrahedron();
  mesh.positions[3] = {0.5, 0, 0};
  const std::vector<Eigen::Vector3d> start = mesh.positions;
  EXPECT_EQ(Untangle(start, 0.02, Context(1), &mesh).num_thin, 1u);
}

// Voxels at random, whose vertices move by up to a voxel each way: thin walls
// run through each other.
TEST(Untangle, LeavesRandomBlocksWithoutIntersections) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> way(-1, 1);
  size_t num_tangled = 0;
  for (int round = 0; round < 200; ++round) {
    const LabelledCrust block =
        LabelRandomBlock(2 + round % 4, round % 2 != 0, random);
    const IndexedMesh start = Place(block, UnitVoxels(4));
    IndexedMesh mesh = start;
    for (Eigen::Vector3d& position : mesh.positions) {
      position += Eigen::Vector3d(way(random), way(random), way(random));
    }
    num_tangled += NumIntersections(mesh) > 0 ? 1 : 0;
    const WithdrawSummary summary =
        Untangle(start.positions, 0.02, Context(2), &mesh);
    EXPECT_EQ(summary.num_thin, 0u);
    EXPECT_EQ(NumIntersections(mesh), 0u) << round;
    if (!mesh.triangles.empty()) {
      ExpectClosedManifold(AuditMesh(mesh, Context(1)));
    }
  }
  EXPECT_GT(num_tangled, 100u);
}

// Compilers have left the rounding out where they vectorized it.
TEST(RoundToFloats, RoundsEveryCoordinate) {
  std::vector<Eigen::Vector3d> positions(5, Eigen::Vector3d(0.1, 0.2, 0.3));
  std::vector<Eigen::Vector3d> one_by_one = positions;
  RoundToFloats(&positions);
  for (Eigen::Vector3d& position : one_by_one) {
    position = RoundedToFloats(position);
  }
  const Eigen::Vector3d floats(
      0.100000001490116119, 0.200000002980232239, 0.300000011920928955);
  EXPECT_EQ(positions, std::vector<Eigen::Vector3d>(5, floats));
  EXPECT_EQ(one_by_one, positions);
}

// What is half-way back need not be a float, and what does not intersect there
// may when it is rounded.
TEST(UntangleFloats, LeavesFloatsWithoutIntersections) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> way(-1, 1);
  size_t num_half_way = 0;
  for (int round = 0; round < 100; ++round) {
    // Far off the origin the last bit of a float is a hundredth of a voxel.
    const Eigen::Vector3d offset = Eigen::Vector3d::Constant(1e5);
    IndexedMesh start =
        Place(LabelRandomBlock(2 + round % 4, true, random), UnitVoxels(4));
    for (Eigen::Vector3d& position : start.positions) {
      position += offset;
    }
    RoundToFloats(&start.positions);
    if (NumIntersections(start) > 0) {
      continue;
    }
    IndexedMesh mesh = start;
    for (Eigen::Vector3d& position : mesh.positions) {
      position += Eigen::Vector3d(way(random), way(random), way(random));
    }
    RoundToFloats(&mesh.positions);
    const std::vector<Eigen::Vector3d> moved = mesh.positions;
    UntangleFloats(start.positions, 0.02, Context(2), &mesh);
    EXPECT_EQ(NumIntersections(mesh), 0u) << round;
    for (size_t v = 0; v < moved.size(); ++v) {
      EXPECT_EQ(mesh.positions[v], RoundedToFloats(mesh.positions[v]));
      num_half_way += mesh.positions[v] != moved[v] &&
                              mesh.positions[v] != start.positions[v]
                          ? 1
                          : 0;
    }
  }
  EXPECT_GT(num_half_way, 100u);
}

}  // namespace
}  // namespace octacut
