#include "core/pipeline/needed_components.h"

#include <gtest/gtest.h>

#include "tests/core/verdict/sphere_views.h"

namespace octacut {
namespace {

using testing::MakeSphereViews;
using testing::SphereViews;

IndexedMesh BallAt(const Eigen::Vector3d& center, double radius) {
  return Sphere(12, [&](const Eigen::Vector3d& direction) -> Eigen::Vector3d {
    return center + radius * direction;
  });
}

void Append(const IndexedMesh& part, IndexedMesh* mesh) {
  const auto first = uint32_t(mesh->positions.size());
  mesh->positions.insert(
      mesh->positions.end(), part.positions.begin(), part.positions.end());
  for (const auto& t : part.triangles) {
    mesh->triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

// A ball that has lost its outer parts, and small ones.
TEST(NeededComponents, AreThoseThatSilhouettesMiss) {
  const SphereViews sphere = MakeSphereViews();
  const Eigen::Vector3d up(0, 0, SphereViews::kRadius);
  KeptComponents kept;
  kept.mesh = SphereViews::Ball(0.7);
  const size_t num_triangles = kept.mesh.triangles.size();
  const IndexedMesh needed = BallAt(0.85 * up, 0.08);
  Append(BallAt(-0.85 * up, 0.004), &kept.removed);  // a crumb
  Append(needed, &kept.removed);
  Append(BallAt(0.3 * up, 0.08), &kept.removed);  // covered
  kept.summary.num_removed = 3;
  EXPECT_EQ(RestoreNeededComponents(
                sphere.test.views, sphere.test.region.cube, Context(2), &kept),
            1u);
  EXPECT_EQ(kept.summary.num_removed, 2u);
  EXPECT_EQ(kept.mesh.triangles.size(),
            num_triangles + needed.triangles.size());
  EXPECT_EQ(kept.removed.triangles.size(), 2 * needed.triangles.size());
  EXPECT_EQ(kept.mesh.positions.back(), needed.positions.back());
}

TEST(NeededComponents, OneOfThoseThatCoverTheSamePixels) {
  const SphereViews sphere = MakeSphereViews();
  const Eigen::Vector3d up(0, 0, SphereViews::kRadius);
  KeptComponents kept;
  kept.mesh = SphereViews::Ball(0.7);
  const size_t num_triangles = kept.mesh.triangles.size();
  const IndexedMesh larger = Sphere(16, [&](const Eigen::Vector3d& direction) {
    return Eigen::Vector3d(0.85 * up + 0.08 * direction);
  });
  Append(BallAt(0.85 * up, 0.07), &kept.removed);
  Append(larger, &kept.removed);
  kept.summary.num_removed = 2;
  EXPECT_EQ(RestoreNeededComponents(
                sphere.test.views, sphere.test.region.cube, Context(2), &kept),
            1u);
  EXPECT_EQ(kept.summary.num_removed, 1u);
  EXPECT_EQ(kept.mesh.triangles.size(),
            num_triangles + larger.triangles.size());
}

TEST(NeededComponents, OfNoneAreNone) {
  const SphereViews sphere = MakeSphereViews();
  KeptComponents kept;
  kept.mesh = SphereViews::Ball(0.7);
  EXPECT_EQ(RestoreNeededComponents(
                sphere.test.views, sphere.test.region.cube, Context(2), &kept),
            0u);
}

}  // namespace
}  // namespace octacut
