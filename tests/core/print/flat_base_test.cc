#include "core/print/flat_base.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/mesh/audit.h"
#include "core/mesh/self_intersections.h"
#include "core/mesh/untangle.h"
#include "tests/core/print/print_shapes.h"

namespace octacut {
namespace {

constexpr double kPi = std::numbers::pi;
const Context kContext(1);

// As floats, `depth` below the plane.
IndexedMesh Lowered(const IndexedMesh& mesh, double depth) {
  IndexedMesh lowered = Moved(mesh, Eigen::Vector3d(0, 0, -depth));
  RoundToFloats(&lowered.positions);
  return lowered;
}

MeshAudit ExpectClosedOnPlate(const FlatBase& base) {
  MeshAudit audit = AuditMesh(base.mesh, Context(1));
  EXPECT_EQ(audit.DescribeFailure(), "");
  EXPECT_EQ(audit.bounding_box.min().z(), 0);
  EXPECT_EQ(FindSelfIntersections(base.mesh, kContext).num_pairs, 0u);
  return audit;
}

TEST(CutFlatBase, SphereLosesItsCap) {
  const double depth = 0.3;
  const FlatBase base =
      CutFlatBase(Lowered(Moved(Sphere(60), {0, 0, 1}), depth), kContext);
  const MeshAudit audit = ExpectClosedOnPlate(base);
  const double sole = kPi * (2 * depth - depth * depth);
  const double cap = kPi * depth * depth * (3 - depth) / 3;
  EXPECT_NEAR(base.area, sole, 0.005 * sole);
  EXPECT_NEAR(audit.volume, 4 * kPi / 3 - cap, 0.005 * audit.volume);
  EXPECT_NEAR(audit.area, 4 * kPi - 2 * kPi * depth + sole, 0.005 * audit.area);
  EXPECT_EQ(base.num_islands, 1u);
  EXPECT_EQ(audit.genus, 0);
}

// All corners of the cut are in line on four sides; whole rows of vertices lie
// in the plane where the depth is a multiple of an eighth.
TEST(CutFlatBase, CubeAtAndBetweenItsVertices) {
  for (const double depth : {0.2, 0.25, 0.5}) {
    const FlatBase base = CutFlatBase(Lowered(Cube(8), depth), kContext);
    const MeshAudit audit = ExpectClosedOnPlate(base);
    EXPECT_NEAR(base.area, 1, 1e-6);
    EXPECT_NEAR(audit.volume, 1 - depth, 1e-6);
    EXPECT_EQ(base.num_islands, 1u);
  }
}

TEST(CutFlatBase, CavityLeavesAHoleInTheBase) {
  const double wall = 0.2;
  const FlatBase base =
      CutFlatBase(Lowered(BoxWithWall(7, wall), 0.5), kContext);
  const MeshAudit audit = ExpectClosedOnPlate(base);
  const double hole = (1 - 2 * wall) * (1 - 2 * wall);
  EXPECT_NEAR(base.area, 1 - hole, 1e-6);
  EXPECT_NEAR(audit.volume, 0.5 - hole * (0.5 - wall), 1e-6);
  EXPECT_EQ(base.num_islands, 1u);
  EXPECT_EQ(audit.num_components, 1u);
}

// A ring that stands up: cut low, one sole; cut higher, two legs.
TEST(CutFlatBase, LegsAreIslands) {
  IndexedMesh ring = Torus(48, 1, 0.3);
  for (Eigen::Vector3d& position : ring.positions) {
    position = Eigen::Vector3d(position.y(), position.z(), position.x() + 1.3);
  }
  const FlatBase low = CutFlatBase(Lowered(ring, 0.1), kContext);
  EXPECT_EQ(ExpectClosedOnPlate(low).genus, 1);
  EXPECT_EQ(low.num_islands, 1u);
  const FlatBase high = CutFlatBase(Lowered(ring, 1.3), kContext);
  EXPECT_EQ(ExpectClosedOnPlate(high).genus, 0);
  EXPECT_EQ(high.num_islands, 2u);
  EXPECT_NEAR(high.area, 2 * kPi * 0.09, 0.02);
}

TEST(CutFlatBase, ColoursGoOnToTheCut) {
  IndexedMesh mesh = Lowered(Moved(Sphere(20), {0, 0, 1}), 0.4);
  for (const Eigen::Vector3d& p : mesh.positions) {
    mesh.colors.push_back({uint8_t(std::lround(128 + 100 * p.x())), 7, 9});
  }
  const FlatBase base = CutFlatBase(mesh, kContext);
  ASSERT_EQ(base.mesh.colors.size(), base.mesh.positions.size());
  for (size_t v = 0; v < base.mesh.colors.size(); ++v) {
    EXPECT_NEAR(
        base.mesh.colors[v][0], 128 + 100 * base.mesh.positions[v].x(), 2);
    EXPECT_EQ(base.mesh.colors[v][1], 7);
  }
}

TEST(CutFlatBase, PotatoesAtAnyHeight) {
  const IndexedMesh potato = Moved(Potato(24), {0, 0, 1});
  for (int i = 1; i < 20; ++i) {
    ExpectClosedOnPlate(CutFlatBase(Lowered(potato, 0.1 * i), kContext));
  }
}

// Large triangles, cut where a twentieth of an edge is much of what is left.
TEST(CutFlatBase, KeepsTheHeightOfCoarseMeshes) {
  const FlatBase base = CutFlatBase(Lowered(Cube(1), 0.99), kContext);
  EXPECT_NEAR(ExpectClosedOnPlate(base).bounding_box.max().z(), 0.01, 2e-4);
}

TEST(CutFlatBase, RefusesACutThatCutsNothingOff) {
  EXPECT_THROW(CutFlatBase(Cube(8), kContext), InputError);
}

TEST(CutFlatBase, IntersectingPartsAreRefused) {
  const IndexedMesh mesh =
      Joined(Sphere(10), Moved(Sphere(10), {0.51, 0.03, 0.02}));
  EXPECT_THROW(CutFlatBase(Lowered(mesh, 0), kContext), InputError);
}

}  // namespace
}  // namespace octacut
