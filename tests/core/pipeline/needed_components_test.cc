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

// Views of a ball whose mesh has lost its outer parts.
struct SmallBall {
  SmallBall() { kept.mesh = SphereViews::Ball(0.7); }

  void Remove(const IndexedMesh& part) {
    Append(part, &kept.removed);
    ++kept.num_removed;
  }

  size_t Restore() {
    return RestoreNeededComponents(
        sphere.test.views, sphere.test.region.cube, Context(2), &kept);
  }

  const Eigen::Vector3d up{0, 0, SphereViews::kRadius};
  const SphereViews sphere = MakeSphereViews();
  KeptComponents kept;
};

TEST(NeededComponents, AreThoseThatSilhouettesMiss) {
  SmallBall ball;
  const size_t num_triangles = ball.kept.mesh.triangles.size();
  const IndexedMesh needed = BallAt(0.85 * ball.up, 0.08);
  ball.Remove(BallAt(-0.85 * ball.up, 0.004));  // a crumb
  ball.Remove(needed);
  ball.Remove(BallAt(0.3 * ball.up, 0.08));  // covered
  EXPECT_EQ(ball.Restore(), 1u);
  EXPECT_EQ(ball.kept.num_removed, 2u);
  EXPECT_EQ(ball.kept.mesh.triangles.size(),
            num_triangles + needed.triangles.size());
  EXPECT_EQ(ball.kept.removed.triangles.size(), 2 * needed.triangles.size());
  EXPECT_EQ(ball.kept.mesh.positions.back(), needed.positions.back());
}

TEST(NeededComponents, OneOfThoseThatCoverTheSamePixels) {
  SmallBall ball;
  const size_t num_triangles = ball.kept.mesh.triangles.size();
  const IndexedMesh larger = Sphere(16, [&](const Eigen::Vector3d& direction) {
    return Eigen::Vector3d(0.85 * ball.up + 0.08 * direction);
  });
  ball.Remove(BallAt(0.85 * ball.up, 0.07));
  ball.Remove(larger);
  EXPECT_EQ(ball.Restore(), 1u);
  EXPECT_EQ(ball.kept.num_removed, 1u);
  EXPECT_EQ(ball.kept.mesh.triangles.size(),
            num_triangles + larger.triangles.size());
}

TEST(NeededComponents, OfNoneAreNone) { EXPECT_EQ(SmallBall().Restore(), 0u); }

}  // namespace
}  // namespace octacut
