#include "core/mesh/extract_surface.h"

#include <gtest/gtest.h>

#include <random>

#include "core/base/error.h"
#include "core/mesh/audit.h"
#include "tests/core/mesh/random_labels.h"

namespace octacut {
namespace {

BoundingCube UnitVoxelCube(int level) {
  return {Eigen::Vector3d::Zero(), double(1 << level)};
}

// A closed labelling may still have components without volume.
void ExpectClosedManifold(const MeshAudit& audit) {
  EXPECT_TRUE(audit.IsClosed());
  EXPECT_EQ(audit.num_nonmanifold_edges, 0);
  EXPECT_EQ(audit.num_nonmanifold_vertices, 0);
  EXPECT_EQ(audit.num_misoriented_edges, 0);
  EXPECT_EQ(audit.num_degenerate_triangles, 0);
  EXPECT_EQ(audit.num_duplicate_triangles, 0);
  EXPECT_EQ(audit.num_unreferenced_vertices, 0);
}

TEST(ExtractSurface, RandomBlocks) {
  std::mt19937 random(1);
  ExtractSurfaceSummary sum;
  for (int round = 0; round < 3000; ++round) {
    const int side = 2 + round % 4;
    const double density = std::uniform_real_distribution<>(0, 1)(random);
    std::bernoulli_distribution coin(density);
    std::uniform_int_distribution<int> shift(0, 16 - side);
    const Eigen::Vector3i low(shift(random), shift(random), shift(random));
    std::vector<uint8_t> faces(3 * 6 * 6 * 6);
    for (uint8_t& face : faces) {
      face = coin(random);
    }
    const LabelledCrust block =
        LabelBlock(4,
                   low,
                   Eigen::Vector3i::Constant(side),
                   round % 2,
                   [&](int axis, int x, int y, int z) {
                     return faces[axis + 3 * (x + 6 * (y + 6 * z))] != 0;
                   });
    const ExtractedSurface surface =
        ExtractSurface(block.crust, block.labels, UnitVoxelCube(4), Context(1));
    sum.num_four_polygon_edges += surface.summary.num_four_polygon_edges;
    sum.num_split_vertices += surface.summary.num_split_vertices;
    sum.num_double_diagonals += surface.summary.num_double_diagonals;
    sum.num_edge_vertices += surface.summary.num_edge_vertices;
    if (surface.summary.num_polygons == 0) {
      continue;
    }
    ExpectClosedManifold(AuditMesh(surface.mesh));
    if (HasFailure()) {
      GTEST_FAIL() << "round " << round << " side " << side;
    }
  }
  EXPECT_GT(sum.num_four_polygon_edges, 0);
  EXPECT_GT(sum.num_split_vertices, 0);
  EXPECT_GT(sum.num_double_diagonals, 0);
  EXPECT_GT(sum.num_edge_vertices, 0);
}

}  // namespace
}  // namespace octacut
