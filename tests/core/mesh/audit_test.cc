#include "core/mesh/audit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/base/error.h"
#include "tests/core/extract/label_crust.h"
#include "tests/core/mesh/simple_meshes.h"

namespace octacut {
namespace {

using testing::HasSubstr;

TEST(AuditMesh, MeasuresABox) {
  const MeshAudit audit = AuditMesh(MakeBox(), Context(1));
  EXPECT_EQ(audit.DescribeFailure(), "");
  EXPECT_NO_THROW(CheckAudit(audit));
  EXPECT_EQ(audit.num_vertices, 8);
  EXPECT_EQ(audit.num_triangles, 12);
  EXPECT_EQ(audit.num_edges, 18);
  EXPECT_EQ(audit.num_components, 1);
  EXPECT_EQ(audit.euler_characteristic, 2);
  EXPECT_EQ(audit.genus, 0);
  EXPECT_DOUBLE_EQ(audit.area, 6);
  EXPECT_DOUBLE_EQ(audit.volume, 1);
  EXPECT_EQ(audit.bounding_box.min(), Eigen::Vector3d::Zero());
  EXPECT_EQ(audit.bounding_box.max(), Eigen::Vector3d::Ones());
}

TEST(AuditMesh, SumsOverComponents) {
  const MeshAudit audit = AuditMesh(
      Combine(MakeBox(), MakeTetrahedron(), {100, 200, 300}), Context(1));
  EXPECT_EQ(audit.DescribeFailure(), "");
  EXPECT_EQ(audit.num_components, 2);
  EXPECT_EQ(audit.euler_characteristic, 4);
  EXPECT_EQ(audit.genus, 0);
  EXPECT_NEAR(audit.volume, 7.0 / 6, 1e-9);
}

TEST(AuditMesh, CountsHandles) {
  // A grid of quads closed both ways.
  IndexedMesh mesh;
  const uint32_t n = 7;
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t j = 0; j < n; ++j) {
      const double u = 2 * M_PI * i / n;
      const double v = 2 * M_PI * j / n;
      const double radius = 2 + std::cos(v);
      mesh.positions.emplace_back(
          radius * std::cos(u), radius * std::sin(u), std::sin(v));
      const uint32_t a = i * n + j;
      const uint32_t b = (i + 1) % n * n + j;
      const uint32_t c = (i + 1) % n * n + (j + 1) % n;
      const uint32_t d = i * n + (j + 1) % n;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  const MeshAudit one = AuditMesh(mesh, Context(1));
  EXPECT_EQ(one.DescribeFailure(), "");
  EXPECT_EQ(one.genus, 1);
  EXPECT_EQ(AuditMesh(Combine(mesh, mesh, {10, 0, 0}), Context(1)).genus, 2);
}

TEST(AuditMesh, CatchesAHole) {
  IndexedMesh mesh = MakeBox();
  mesh.triangles.pop_back();
  const MeshAudit audit = AuditMesh(mesh, Context(1));
  EXPECT_FALSE(audit.IsClosed());
  EXPECT_EQ(audit.num_boundary_edges, 3);
  EXPECT_EQ(audit.num_nonmanifold_vertices, 0);
  EXPECT_EQ(audit.genus, -1);
  EXPECT_THAT(audit.DescribeFailure(), HasSubstr("3 boundary edges"));
  EXPECT_THROW(CheckAudit(audit), InvariantError);
}

TEST(AuditMesh, CatchesAFlippedTriangle) {
  IndexedMesh mesh = MakeBox();
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  const MeshAudit audit = AuditMesh(mesh, Context(1));
  EXPECT_TRUE(audit.IsClosed());
  EXPECT_FALSE(audit.IsOriented());
  EXPECT_EQ(audit.num_misoriented_edges, 3);
  EXPECT_EQ(audit.genus, -1);
  EXPECT_NE(audit.DescribeFailure(), "");
}

TEST(AuditMesh, CatchesAMeshInsideOut) {
  const MeshAudit audit = AuditMesh(TurnInsideOut(MakeBox()), Context(1));
  EXPECT_TRUE(audit.IsOriented());
  EXPECT_FALSE(audit.IsOutward());
  EXPECT_THAT(audit.DescribeFailure(), HasSubstr("volume -1 is not positive"));
}

TEST(AuditMesh, CatchesABowTieVertex) {
  IndexedMesh mesh = Combine(MakeTetrahedron(), MakeTetrahedron(), {2, 0, 0});
  for (auto& triangle : mesh.triangles) {
    for (uint32_t& vertex : triangle) {
      vertex = vertex == 4 ? 1 : vertex;
    }
  }
  const MeshAudit audit = AuditMesh(mesh, Context(1));
  EXPECT_TRUE(audit.IsClosed());
  EXPECT_TRUE(audit.IsEdgeManifold());
  EXPECT_EQ(audit.num_nonmanifold_vertices, 1);
  EXPECT_EQ(audit.num_unreferenced_vertices, 1);
  EXPECT_EQ(audit.genus, -1);
  EXPECT_NE(audit.DescribeFailure(), "");
}

TEST(AuditMesh, CatchesANonManifoldEdge) {
  // Two tetrahedra that share an edge.
  IndexedMesh mesh = Combine(MakeTetrahedron(), MakeTetrahedron(), {2, 0, 0});
  for (auto& triangle : mesh.triangles) {
    for (uint32_t& vertex : triangle) {
      vertex = vertex == 4 ? 0 : (vertex == 7 ? 3 : vertex);
    }
  }
  const MeshAudit audit = AuditMesh(mesh, Context(1));
  EXPECT_TRUE(audit.IsClosed());
  EXPECT_EQ(audit.num_edges, 11);
  EXPECT_EQ(audit.num_nonmanifold_edges, 1);
  EXPECT_EQ(audit.num_nonmanifold_vertices, 2);
  EXPECT_NE(audit.DescribeFailure(), "");
}

TEST(AuditMesh, CatchesDuplicateTriangles) {
  IndexedMesh mesh = MakeBox();
  const auto [a, b, c] = mesh.triangles[3];
  mesh.triangles.push_back({b, c, a});
  mesh.triangles.push_back({c, b, a});
  const MeshAudit audit = AuditMesh(mesh, Context(1));
  EXPECT_EQ(audit.num_duplicate_triangles, 2);
  EXPECT_EQ(audit.num_nonmanifold_edges, 3);
  EXPECT_NE(audit.DescribeFailure(), "");
}

TEST(AuditMesh, CatchesDegenerateTriangles) {
  IndexedMesh repeated = MakeBox();
  repeated.triangles.push_back({3, 3, 5});
  const MeshAudit audit = AuditMesh(repeated, Context(1));
  EXPECT_EQ(audit.num_degenerate_triangles, 1);
  EXPECT_EQ(audit.num_nonmanifold_edges, 0);
  EXPECT_NE(audit.DescribeFailure(), "");

  // A corner pulled onto the opposite side.
  IndexedMesh flat = MakeTetrahedron();
  flat.positions[3] = {0.5, 0, 0};
  EXPECT_EQ(AuditMesh(flat, Context(1)).num_degenerate_triangles, 1);
  // Tiny is not degenerate.
  IndexedMesh tiny = MakeTetrahedron();
  for (Eigen::Vector3d& position : tiny.positions) {
    position *= 1e-9;
  }
  EXPECT_EQ(AuditMesh(tiny, Context(1)).DescribeFailure(), "");
}

TEST(AuditMesh, CatchesCoordinatesThatAreNotFinite) {
  IndexedMesh mesh = Combine(MakeBox(), MakeTetrahedron(), {5, 0, 0});
  mesh.positions[9].y() = std::numeric_limits<double>::quiet_NaN();
  const MeshAudit audit = AuditMesh(mesh, Context(1));
  EXPECT_EQ(audit.num_nonfinite_vertices, 1);
  EXPECT_TRUE(std::isfinite(audit.area));
  EXPECT_TRUE(audit.bounding_box.min().allFinite());
  EXPECT_THAT(audit.DescribeFailure(), HasSubstr("1 vertices that are not"));
}

TEST(AuditMesh, CatchesUnreferencedVertices) {
  IndexedMesh mesh = MakeBox();
  mesh.positions.emplace_back(9, 9, 9);
  const MeshAudit audit = AuditMesh(mesh, Context(1));
  EXPECT_EQ(audit.num_unreferenced_vertices, 1);
  EXPECT_EQ(audit.euler_characteristic, 2);
  EXPECT_EQ(audit.bounding_box.max(), Eigen::Vector3d::Ones());
  EXPECT_NE(audit.DescribeFailure(), "");
}

TEST(AuditMesh, RefusesIndicesOutOfRange) {
  IndexedMesh mesh = MakeBox();
  mesh.triangles[0][0] = 8;
  EXPECT_THROW(AuditMesh(mesh, Context(1)), InputError);
}

TEST(AuditMesh, EmptyMeshIsNotPrintable) {
  EXPECT_EQ(AuditMesh(IndexedMesh(), Context(1)).DescribeFailure(),
            "no triangles");
}

TEST(AuditMesh, OpenFansAreManifoldVertices) {
  IndexedMesh fan;
  fan.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
  fan.triangles = {{0, 1, 2}, {0, 2, 3}};
  const MeshAudit audit = AuditMesh(fan, Context(1));
  EXPECT_EQ(audit.num_nonmanifold_vertices, 0);
  EXPECT_EQ(audit.num_boundary_edges, 4);
  EXPECT_EQ(audit.euler_characteristic, 1);
  EXPECT_DOUBLE_EQ(audit.area, 1);
}

TEST(AuditMesh, SameFiguresForAnyNumberOfThreads) {
  std::mt19937 random(3);
  IndexedMesh soup;
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int i = 0; i < 70000; ++i) {
    soup.positions.emplace_back(
        coordinate(random), coordinate(random), coordinate(random));
  }
  std::uniform_int_distribution<uint32_t> vertex(0, 69999);
  for (int i = 0; i < 200000; ++i) {
    soup.triangles.push_back({vertex(random), vertex(random), vertex(random)});
  }
  const MeshAudit expected = AuditMesh(soup, Context(1));
  for (const int num_threads : {2, 4}) {
    const MeshAudit actual = AuditMesh(soup, Context(num_threads));
    EXPECT_EQ(actual.num_edges, expected.num_edges);
    EXPECT_EQ(actual.num_boundary_edges, expected.num_boundary_edges);
    EXPECT_EQ(actual.num_nonmanifold_edges, expected.num_nonmanifold_edges);
    EXPECT_EQ(actual.num_nonmanifold_vertices,
              expected.num_nonmanifold_vertices);
    EXPECT_EQ(actual.area, expected.area);
    EXPECT_EQ(actual.volume, expected.volume);
  }
}

}  // namespace
}  // namespace octacut
