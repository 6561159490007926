#include "core/extract/position_vertices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/extract/label_crust.h"

namespace octacut {
namespace {

double SmallestHeight(const IndexedMesh& mesh) {
  double smallest = 1e9;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d ab = mesh.positions[t[1]] - mesh.positions[t[0]];
    const Eigen::Vector3d ac = mesh.positions[t[2]] - mesh.positions[t[0]];
    const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
    smallest = std::min(smallest, ab.cross(ac).norm() / longest);
  }
  return smallest;
}

// Polygons of the same corners belong to the voxels above or below them: the
// last inside faces are the sides of the lower voxels, or the faces above.
TEST(PositionVertices, PutsAFlatCutIntoTheMiddleOfItsVoxels) {
  for (const bool cuts_upper : {false, true}) {
    const LabelledCrust slab = LabelBlock(
        4, {2, 2, 2}, {8, 8, 8}, false, [&](int axis, int x, int y, int z) {
          const bool on_side =
              x < 1 || y < 1 || x + (axis != 0) > 7 || y + (axis != 1) > 7;
          const int last = axis == 2 && cuts_upper ? 5 : 4;
          return !on_side && z >= 2 && z <= last;
        });
    const ExtractedSurface surface =
        ExtractSurface(slab.crust, slab.labels, UnitVoxels(4), Context(1));
    const IndexedMesh positioned = PositionVertices(surface, Context(1));
    ExpectClosedManifold(AuditMesh(positioned, Context(1)));
    int num_top = 0;
    ASSERT_EQ(positioned.positions.size(), surface.mesh.positions.size());
    for (size_t v = 0; v < positioned.positions.size(); ++v) {
      const Eigen::Vector3d from_middle =
          surface.mesh.positions[v] - Eigen::Vector3d(6, 6, 7);
      if (from_middle.cwiseAbs().maxCoeff() < 1.1 && from_middle.z() == 0) {
        const double height = cuts_upper ? 7.5 : 6.5;
        EXPECT_DOUBLE_EQ(positioned.positions[v].z(), height);
        ++num_top;
      }
    }
    EXPECT_EQ(num_top, 9);
  }
}

TEST(PositionVertices, StaysWithinHalfAVoxelDiagonalAndKeepsTrianglesApart) {
  std::mt19937 random(4);
  for (int round = 0; round < 600; ++round) {
    const LabelledCrust block =
        LabelRandomBlock(2 + round % 4, round % 2 != 0, random);
    const ExtractedSurface surface =
        ExtractSurface(block.crust, block.labels, UnitVoxels(4), Context(1));
    const IndexedMesh positioned = PositionVertices(surface, Context(1));
    if (positioned.triangles.empty()) {
      continue;
    }
    ASSERT_EQ(positioned.positions.size(), surface.mesh.positions.size());
    EXPECT_EQ(positioned.triangles, surface.mesh.triangles);
    for (size_t v = 0; v < positioned.positions.size(); ++v) {
      EXPECT_LE((positioned.positions[v] - surface.mesh.positions[v]).norm(),
                std::sqrt(3.0) / 2 + 1e-12);
    }
    ExpectClosedManifold(AuditMesh(positioned, Context(1)));
    EXPECT_GE(SmallestHeight(positioned), 0.02 - 1e-12);
    EXPECT_EQ(NumIntersections(positioned), 0u);
  }
}

TEST(PositionVertices, SingleFaceKeepsItsArea) {
  // Both polygons collapse into the centre of the face otherwise.
  const LabelledCrust block = LabelBlock(
      2, {1, 1, 1}, {2, 1, 1}, false, [](int, int, int, int) { return true; });
  const IndexedMesh positioned = Place(block, UnitVoxels(2));
  const MeshAudit audit = AuditMesh(positioned, Context(1));
  EXPECT_EQ(audit.DescribeFailure(), "");
  EXPECT_GE(SmallestHeight(positioned), 0.02 - 1e-12);
}

TEST(PositionVertices, VolumeOfASphereIsUnbiased) {
  for (const int level : {5, 6, 7}) {
    const double voxel = 1.0 / (1 << level);
    const IndexedMesh positioned =
        Place(LabelShape(level, SphereDistance), UnitCube());
    double mean = 0;
    double largest = 0;
    for (const Eigen::Vector3d& position : positioned.positions) {
      const double distance = SphereDistance(position) / voxel;
      mean += distance / double(positioned.positions.size());
      largest = std::max(largest, std::abs(distance));
    }
    EXPECT_LT(std::abs(mean), 0.02) << "level " << level;
    EXPECT_LT(largest, 0.6) << "level " << level;
    const double exact = 4.0 / 3 * M_PI * std::pow(0.4, 3);
    // Triangles cut the sphere's caps off: of the order of (voxel / radius)^2.
    const double tolerance = 1.5 * voxel * voxel / (0.4 * 0.4);
    EXPECT_NEAR(AuditMesh(positioned, Context(1)).volume / exact, 1, tolerance)
        << "level " << level;
  }
}

}  // namespace
}  // namespace octacut
