#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/mesh/audit.h"
#include "core/mesh/keep_components.h"
#include "core/mesh/normals.h"
#include "core/mesh/surface_mesh.h"
#include "tests/core/mesh/simple_meshes.h"

namespace octacut {
namespace {

TEST(VertexNormals, DoNotDependOnTheTriangulationOfABox) {
  const IndexedMesh box = MakeBox();
  const auto normals = ComputeVertexNormals(box, Context(1));
  ASSERT_EQ(normals.size(), 8);
  for (size_t v = 0; v < 8; ++v) {
    const Eigen::Vector3d outward =
        box.positions[v] - Eigen::Vector3d::Constant(0.5);
    EXPECT_NEAR(normals[v].norm(), 1, 1e-6);
    EXPECT_LT((normals[v] - outward.normalized().cast<float>()).norm(), 1e-6);
  }
}

TEST(VertexNormals, SurviveDegenerateTrianglesAndLoneVertices) {
  IndexedMesh mesh = MakeBox();
  mesh.positions.emplace_back(3, 3, 3);
  mesh.triangles.push_back({0, 0, 1});
  const auto normals = ComputeVertexNormals(mesh, Context(1));
  EXPECT_EQ(normals[8], Eigen::Vector3f::UnitZ());
  for (const Eigen::Vector3f& normal : normals) {
    EXPECT_TRUE(normal.allFinite());
  }
}

TEST(SurfaceMesh, RoundTrip) {
  IndexedMesh mesh = Combine(MakeBox(), MakeOctahedron(), {3, 0, 0});
  mesh.normals = ComputeVertexNormals(mesh, Context(1));
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.colors.push_back({uint8_t(v), uint8_t(2 * v), uint8_t(255 - v)});
  }
  const IndexedMesh back = ToIndexedMesh(ToSurfaceMesh(mesh));
  EXPECT_EQ(back.positions, mesh.positions);
  EXPECT_EQ(back.normals, mesh.normals);
  EXPECT_EQ(back.colors, mesh.colors);
  EXPECT_EQ(back.triangles, mesh.triangles);
}

TEST(SurfaceMesh, LeavesOutNormalsAndColorsThatAreNotThere) {
  const IndexedMesh back = ToIndexedMesh(ToSurfaceMesh(MakeBox()));
  EXPECT_TRUE(back.normals.empty());
  EXPECT_TRUE(back.colors.empty());
}

// Two tetrahedra joined in the given vertices of both.
IndexedMesh Joined(const std::vector<uint32_t>& vertices) {
  IndexedMesh mesh = Combine(MakeTetrahedron(), MakeTetrahedron(), {2, 0, 0});
  for (auto& triangle : mesh.triangles) {
    for (uint32_t& vertex : triangle) {
      for (const uint32_t joined : vertices) {
        vertex = vertex == 4 + joined ? joined : vertex;
      }
    }
  }
  return mesh;
}

TEST(SurfaceMesh, RefusesWhatIsNoManifold) {
  EXPECT_THROW(ToSurfaceMesh(Joined({0, 3})), InvariantError);  // edge
  EXPECT_THROW(ToSurfaceMesh(Joined({1})), InvariantError);     // vertex
  IndexedMesh flipped = MakeBox();
  std::swap(flipped.triangles[0][0], flipped.triangles[0][1]);
  EXPECT_THROW(ToSurfaceMesh(flipped), InvariantError);
  IndexedMesh repeated = MakeBox();
  repeated.triangles[0][0] = repeated.triangles[0][1];
  EXPECT_THROW(ToSurfaceMesh(repeated), InvariantError);
  IndexedMesh beyond = MakeBox();
  beyond.triangles[0][0] = 8;
  EXPECT_THROW(ToSurfaceMesh(beyond), InvariantError);
}

IndexedMesh Scaled(IndexedMesh mesh, double factor) {
  for (Eigen::Vector3d& position : mesh.positions) {
    position *= factor;
  }
  return mesh;
}

TEST(KeepLargestComponents, RemovesCrumbsAndSmallCavities) {
  // Volumes 8, 1 and -1/48.
  const IndexedMesh large = Scaled(MakeBox(), 2);
  const IndexedMesh cavity = TurnInsideOut(Scaled(MakeTetrahedron(), 0.5));
  IndexedMesh mesh = Combine(MakeBox(), large, {5, 0, 0});
  mesh = Combine(mesh, cavity, {6, 1, 1});

  ASSERT_EQ(AuditMesh(mesh, Context(1)).num_components, 3u);
  const KeptComponents all = KeepLargestComponents(mesh, 0);
  EXPECT_EQ(all.num_removed, 0);
  EXPECT_EQ(all.mesh.triangles, mesh.triangles);

  const KeptComponents two = KeepLargestComponents(mesh, 0.1);
  EXPECT_EQ(two.num_removed, 1);
  EXPECT_EQ(two.mesh.triangles.size() + 4, mesh.triangles.size());
  EXPECT_NEAR(AuditMesh(two.mesh, Context(1)).volume, 9, 1e-12);
  EXPECT_TRUE(two.removed.triangles.empty());  // a cavity is no loss

  const KeptComponents one = KeepLargestComponents(mesh, 1);
  EXPECT_EQ(one.num_removed, 2);
  const MeshAudit audit = AuditMesh(one.mesh, Context(1));
  EXPECT_EQ(audit.DescribeFailure(), "");
  EXPECT_NEAR(audit.volume, 8, 1e-12);
  EXPECT_EQ(audit.bounding_box.min(), Eigen::Vector3d(5, 0, 0));
  EXPECT_NEAR(AuditMesh(one.removed, Context(1)).volume, 1, 1e-12);
}

TEST(KeepLargestComponents, OfEqualOnesTheFirstIsTheLargest) {
  const KeptComponents one =
      KeepLargestComponents(Combine(MakeBox(), MakeBox(), {5, 0, 0}), 1);
  EXPECT_EQ(AuditMesh(one.mesh, Context(1)).num_components, 1);
  EXPECT_EQ(one.mesh.positions[0], Eigen::Vector3d::Zero());
}

TEST(KeepLargestComponents, RefusesBadFractions) {
  for (const double fraction : {-0.1, 1.1, double(NAN)}) {
    EXPECT_THROW(KeepLargestComponents(MakeBox(), fraction), OptionError);
  }
  EXPECT_TRUE(KeepLargestComponents(IndexedMesh(), 0.5).mesh.triangles.empty());
}

}  // namespace
}  // namespace octacut
