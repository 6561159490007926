#include "core/simplify/simplify_mesh.h"

#include <gtest/gtest.h>

#include <map>

#include "core/benchmark/compare/compare_meshes.h"
#include "core/mesh/audit.h"
#include "core/mesh/self_intersections.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

const Context kContext(1);

CollapseReplay Prepared(const IndexedMesh& full, size_t num_triangles) {
  return {full, num_triangles, kContext};
}

CompareMeshesOptions Samples(int64_t count) {
  CompareMeshesOptions options;
  options.num_samples = count;
  return options;
}

void ExpectClosed(const IndexedMesh& mesh) {
  EXPECT_EQ(AuditMesh(mesh, Context(1)).DescribeFailure(), "");
  EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
}

// A colour for each vertex that tells where it is.
IndexedMesh Painted(IndexedMesh mesh) {
  for (const Eigen::Vector3d& p : mesh.positions) {
    mesh.colors.push_back({uint8_t(128 + 50 * p.x()),
                           uint8_t(128 + 50 * p.y()),
                           uint8_t(128 + 50 * p.z())});
    mesh.confidence.push_back(float(p.x()));
  }
  return mesh;
}

TEST(SimplifyMesh, ReachesTheNumberOfTriangles) {
  const IndexedMesh full = Potato(30);  // 10800 triangles
  const CollapseReplay replay = Prepared(full, 100);
  EXPECT_EQ(replay.LeastTriangles(), 100u);
  for (const size_t target : {10800u, 9999u, 5000u, 1080u, 101u}) {
    const SimplifiedMesh result = SimplifyTo(target, replay, kContext);
    EXPECT_EQ(result.mesh.triangles.size(), target - target % 2);
    ExpectClosed(result.mesh);
    EXPECT_EQ(AuditMesh(result.mesh, Context(1)).genus, 0);
    EXPECT_EQ(FindSelfIntersections(result.mesh, kContext).num_pairs, 0u);
  }
}

TEST(SimplifyMesh, ATenthOfTheTrianglesStaysClose) {
  const IndexedMesh full = Potato(60);  // 43200 triangles
  const SimplifiedMesh result =
      SimplifyTo(4320, Prepared(full, 4320), kContext);
  const MeshComparison comparison =
      CompareMeshes(result.mesh, full, Samples(20000), kContext);
  const double diagonal = comparison.reference_diagonal;
  // A regular mesh of so few triangles, edges of 0.1 on a radius of 1, has a
  // mean distance of about 0.03 % of the diagonal.
  EXPECT_LT(comparison.from_reference.mean, 3e-4 * diagonal);
  EXPECT_LT(comparison.Hausdorff(), 3e-3 * diagonal);
  // The mesh does have fewer triangles than it would need to be exact.
  EXPECT_GT(comparison.from_reference.mean, 1e-6 * diagonal);
}

TEST(SimplifyMesh, VerticesKeepPlaceColourAndConfidence) {
  const IndexedMesh full = Painted(Potato(20));
  const SimplifiedMesh result = SimplifyTo(480, Prepared(full, 480), kContext);
  std::map<std::array<double, 3>, size_t> numbers;
  for (size_t v = 0; v < full.positions.size(); ++v) {
    const Eigen::Vector3d& p = full.positions[v];
    numbers[{p.x(), p.y(), p.z()}] = v;
  }
  ASSERT_EQ(result.mesh.colors.size(), result.mesh.positions.size());
  ASSERT_EQ(result.mesh.confidence.size(), result.mesh.positions.size());
  for (size_t v = 0; v < result.mesh.positions.size(); ++v) {
    const Eigen::Vector3d& p = result.mesh.positions[v];
    const auto found = numbers.find({p.x(), p.y(), p.z()});
    ASSERT_NE(found, numbers.end());
    EXPECT_EQ(result.mesh.colors[v], full.colors[found->second]);
    EXPECT_EQ(result.mesh.confidence[v], full.confidence[found->second]);
  }
}

// A plane needs no vertices but its corners'; none may become a needle.
TEST(SimplifyMesh, ACubeKeepsItsShape) {
  const IndexedMesh full = Cube(24);
  const SimplifiedMesh result = SimplifyTo(200, Prepared(full, 200), kContext);
  ExpectClosed(result.mesh);
  EXPECT_EQ(result.mesh.triangles.size(), 200u);
  const MeshAudit audit = AuditMesh(result.mesh, Context(1));
  EXPECT_NEAR(audit.volume, 1, 1e-9);
  EXPECT_NEAR(audit.area, 6, 1e-9);
}

// Two skins so close that coarse triangles of one go through the other.
TEST(SimplifyMesh, CloseSkinsDoNotIntersect) {
  IndexedMesh inner = Sphere(40, 0.995);
  for (auto& triangle : inner.triangles) {
    std::swap(triangle[0], triangle[1]);
  }
  const IndexedMesh full = Joined(Sphere(43), inner);
  const CollapseReplay replay = Prepared(full, 600);
  const CollapsedMesh careless = replay.Run(600, {});
  EXPECT_GT(FindSelfIntersections(careless.mesh, kContext).num_pairs, 0u);
  const SimplifiedMesh result = SimplifyTo(600, replay, kContext);
  EXPECT_GT(result.summary.num_repairs, 0u);
  EXPECT_GT(result.summary.num_held, 0u);
  EXPECT_EQ(result.summary.num_old_intersections, 0u);
  EXPECT_EQ(FindSelfIntersections(result.mesh, kContext).num_pairs, 0u);
  ExpectClosed(result.mesh);
}

TEST(SimplifyMesh, IntersectionsOfTheFullMeshAreCounted) {
  const IndexedMesh full =
      Joined(Sphere(8), Moved(Sphere(8), Eigen::Vector3d(1.01, 0.03, 0.02)));
  const size_t num_pairs = FindSelfIntersections(full, kContext).num_pairs;
  ASSERT_GT(num_pairs, 0u);
  const SimplifiedMesh result = SimplifyTo(100, Prepared(full, 100), kContext);
  EXPECT_LT(result.mesh.triangles.size(), full.triangles.size());
  const size_t num_left =
      FindSelfIntersections(result.mesh, kContext).num_pairs;
  EXPECT_EQ(result.summary.num_old_intersections, num_left);
  EXPECT_LE(num_left, num_pairs);
}

TEST(SimplifyMesh, StopsWhereNoCollapseIsAllowed) {
  const IndexedMesh full = Sphere(6);
  const SimplifiedMesh result = SimplifyTo(4, Prepared(full, 4), kContext);
  ExpectClosed(result.mesh);
  EXPECT_GE(result.mesh.triangles.size(), 4u);
  EXPECT_LT(result.mesh.triangles.size(), 40u);
}

TEST(SimplifyMesh, KeepsTheDistance) {
  const IndexedMesh full = Potato(30);
  const CollapseReplay replay = Prepared(full, 4);
  const auto hausdorff = [&](const IndexedMesh& mesh) {
    return CompareMeshes(mesh, full, Samples(5000), kContext).Hausdorff();
  };
  size_t num_before = full.triangles.size() + 1;
  for (const double limit : {1e-5, 0.001, 0.01, 0.1}) {
    const SimplifiedMesh result =
        SimplifyWithin(limit, hausdorff, replay, kContext);
    EXPECT_LE(hausdorff(result.mesh), limit);
    EXPECT_LT(result.mesh.triangles.size(), num_before);
    num_before = result.mesh.triangles.size();
    // A tenth fewer would be too far.
    if (limit < 0.1) {
      const SimplifiedMesh fewer =
          SimplifyTo(num_before - num_before / 10, replay, kContext);
      EXPECT_GT(hausdorff(fewer.mesh), limit);
    }
  }
}

TEST(SimplifyMesh, ADistanceBelowRoundingLeavesTheMesh) {
  const IndexedMesh full = Sphere(8, 100);
  const auto rounding = [](const IndexedMesh&) { return 1e-14; };
  const SimplifiedMesh simplified =
      SimplifyWithin(1e-18, rounding, Prepared(full, 4), kContext);
  EXPECT_EQ(simplified.mesh.triangles.size(), full.triangles.size());
}

TEST(SimplifyMesh, SizeAndPlaceDoNotMatter) {
  const IndexedMesh full = Potato(12);
  const SimplifiedMesh usual = SimplifyTo(300, Prepared(full, 300), kContext);
  for (const double scale : {0x1p-30, 0x1p40}) {
    IndexedMesh scaled = full;
    for (Eigen::Vector3d& position : scaled.positions) {
      position *= scale;
    }
    const SimplifiedMesh result =
        SimplifyTo(300, Prepared(scaled, 300), kContext);
    EXPECT_EQ(result.mesh.triangles, usual.mesh.triangles);
  }
}

}  // namespace
}  // namespace octacut
