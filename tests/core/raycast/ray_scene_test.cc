#include "core/raycast/ray_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <limits>

#include "core/base/error.h"
#include "core/raycast/triangle.h"
#include "tests/core/raycast/random_mesh.h"

namespace octacut {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// All distances at which the ray meets a triangle, sorted; by solving
// origin + t direction = a + u ab + v ac.
std::vector<double> HitDistances(const IndexedMesh& mesh,
                                 const Eigen::Vector3d& origin,
                                 const Eigen::Vector3d& direction) {
  std::vector<double> distances;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d a = mesh.positions[triangle[0]];
    Eigen::Matrix3d system;
    system << mesh.positions[triangle[1]] - a, mesh.positions[triangle[2]] - a,
        -direction;
    const Eigen::Vector3d uvt = system.inverse() * (origin - a);
    if (uvt.x() >= 0 && uvt.y() >= 0 && uvt.x() + uvt.y() <= 1 &&
        uvt.z() >= 0) {
      distances.push_back(uvt.z());
    }
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

IndexedMesh UnitQuad(const Eigen::Vector3d& offset) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  for (Eigen::Vector3d& position : mesh.positions) {
    position += offset;
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// The centre is far from the origin of the world, as models may be.
class RandomSoups : public ::testing::TestWithParam<double> {
 protected:
  RandomSoups()
      : center_(GetParam() * Eigen::Vector3d(1, -2, 3)),
        mesh_(RandomSoup(rng_, 200, center_, 1.0, 0.4)),
        scene_(mesh_) {}

  std::mt19937 rng_{7};
  Eigen::Vector3d center_;
  IndexedMesh mesh_;
  RayScene scene_;
};

TEST_P(RandomSoups, FirstHitAgreesWithBruteForce) {
  int num_hits = 0;
  int num_differences = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Eigen::Vector3d origin = center_ + RandomPoint(rng_, 4);
    const Eigen::Vector3d target = center_ + RandomPoint(rng_, 1);
    const Eigen::Vector3d direction = 0.1 * (target - origin);
    const auto expected = HitDistances(mesh_, origin, direction);
    const auto hit = scene_.FirstHit(origin, direction);
    // Floats decide otherwise only for rays that all but touch an edge.
    if (hit.has_value() != !expected.empty() ||
        (hit && std::abs(hit->distance - expected.front()) > 1e-9)) {
      ++num_differences;
      continue;
    }
    if (!hit) {
      continue;
    }
    ++num_hits;
    const auto& corners = mesh_.triangles[hit->triangle];
    const double u = hit->barycentric.x();
    const double v = hit->barycentric.y();
    const Eigen::Vector3d point = (1 - u - v) * mesh_.positions[corners[0]] +
                                  u * mesh_.positions[corners[1]] +
                                  v * mesh_.positions[corners[2]];
    EXPECT_LT((origin + hit->distance * direction - point).norm(), 1e-6);
  }
  EXPECT_GT(num_hits, 500);
  EXPECT_LE(num_differences, 1);
}

TEST_P(RandomSoups, MinDistanceSkipsNearerHits) {
  int num_skipped = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const Eigen::Vector3d origin = center_ + RandomPoint(rng_, 4);
    const Eigen::Vector3d direction = center_ + RandomPoint(rng_, 1) - origin;
    const auto expected = HitDistances(mesh_, origin, direction);
    if (expected.size() < 2 || expected[1] - expected[0] < 1e-3) {
      continue;
    }
    const auto hit =
        scene_.FirstHit(origin, direction, (expected[0] + expected[1]) / 2);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->distance, expected[1], 1e-9);
    ++num_skipped;
  }
  EXPECT_GT(num_skipped, 50);
}

TEST_P(RandomSoups, OcclusionAgreesWithBruteForce) {
  int num_occluded = 0;
  int num_free = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Eigen::Vector3d origin = center_ + RandomPoint(rng_, 3);
    const Eigen::Vector3d direction = center_ + RandomPoint(rng_, 1) - origin;
    const double min_distance = 0.3;
    const double max_distance = 0.9;
    bool expected = false;
    bool near_call = false;
    for (const double distance : HitDistances(mesh_, origin, direction)) {
      expected |= distance >= min_distance && distance <= max_distance;
      near_call |= std::abs(distance - min_distance) < 1e-5 ||
                   std::abs(distance - max_distance) < 1e-5;
    }
    if (!near_call) {
      EXPECT_EQ(
          scene_.IsOccluded(origin, direction, min_distance, max_distance),
          expected);
      ++(expected ? num_occluded : num_free);
    }
  }
  EXPECT_GT(num_occluded, 200);
  EXPECT_GT(num_free, 200);
}

TEST_P(RandomSoups, ClosestPointIsExact) {
  for (int trial = 0; trial < 1000; ++trial) {
    const double extent = trial % 3 == 0 ? 30 : 1.5;
    const Eigen::Vector3d query = center_ + RandomPoint(rng_, extent);
    double expected = kInfinity;
    for (const auto& triangle : mesh_.triangles) {
      const Eigen::Vector3d point =
          ClosestPointOnTriangle(query,
                                 mesh_.positions[triangle[0]],
                                 mesh_.positions[triangle[1]],
                                 mesh_.positions[triangle[2]]);
      expected = std::min(expected, (point - query).norm());
    }
    const auto closest = scene_.ClosestPoint(query);
    EXPECT_EQ(closest.distance, expected);
    EXPECT_EQ((closest.point - query).norm(), expected);
    ASSERT_LT(closest.triangle, mesh_.triangles.size());
    // From any triangle the same.
    const auto near = uint32_t(trial * 7) % uint32_t(mesh_.triangles.size());
    const auto again = scene_.ClosestPoint(query, near);
    EXPECT_EQ(again.point, closest.point);
    EXPECT_EQ(again.triangle, closest.triangle);
  }
}

INSTANTIATE_TEST_SUITE_P(Offsets, RandomSoups, ::testing::Values(0.0, 1.0e4));

TEST(RayScene, NoRaySlipsThroughASharedEdge) {
  const RayScene scene(UnitQuad({3, 5, 7}));
  for (int i = 1; i < 1000; ++i) {
    const double along = i / 1000.0;
    const Eigen::Vector3d on_diagonal(3 + along, 5 + along, 7);
    const Eigen::Vector3d origin(1, 6, 20);
    const auto hit = scene.FirstHit(origin, on_diagonal - origin);
    ASSERT_TRUE(hit.has_value()) << along;
    EXPECT_NEAR(hit->distance, 1, 1e-12);
  }
}

TEST(RayScene, DistanceIsPreciseFromFarAway) {
  const RayScene scene(UnitQuad({0, 0, 0}));
  const Eigen::Vector3d origin(0.25, 0.5, 1e7);
  const auto hit = scene.FirstHit(origin, {0, 0, -1});
  ASSERT_TRUE(hit.has_value());
  EXPECT_NEAR(hit->distance, 1e7, 1e-6);
  EXPECT_TRUE(scene.IsOccluded(origin, {0, 0, -1}, 0, 1.1e7));
  EXPECT_FALSE(scene.IsOccluded(origin, {0, 0, -1}, 0, 0.9e7));
  EXPECT_FALSE(scene.FirstHit(origin, {0, 0, 1}).has_value());
}

TEST(RayScene, EqualDistancesGoToTheLowestTriangle) {
  IndexedMesh mesh = UnitQuad({0, 0, 0});
  mesh.triangles.push_back(mesh.triangles[0]);
  std::swap(mesh.triangles[0], mesh.triangles[1]);
  const RayScene scene(mesh);
  EXPECT_EQ(scene.ClosestPoint({0.7, 0.2, 1}).triangle, 1u);
  EXPECT_EQ(scene.ClosestPoint({0.5, 0.5, 1}).triangle, 0u);
}

TEST(RayScene, DegenerateTrianglesHaveClosestPointsOnly) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 1, 1}};
  const RayScene scene(mesh);
  EXPECT_FALSE(scene.FirstHit({0.5, 0, 3}, {0, 0, -1}).has_value());
  const auto closest = scene.ClosestPoint({1.5, 2, 0});
  EXPECT_EQ(closest.triangle, 0u);
  EXPECT_NEAR(closest.distance, 2, 1e-15);
}

// Seen from its own size away times more than floats hold.
TEST(RayScene, NoRayHitsWhatHasNoSize) {
  IndexedMesh mesh;
  for (const double size : {0.0, 1e-30}) {
    mesh.positions = {{1, 1, 1}, {1 + size, 1, 1}, {1, 1 + size, 1}};
    mesh.positions[0] *= size == 0 ? 1 : size;
    mesh.triangles = {{0, 1, 2}};
    const RayScene scene(mesh);
    const Eigen::Vector3d origin(5, 3, 2);
    EXPECT_FALSE(scene.FirstHit(origin, {-4, -1, 3}).has_value());
    EXPECT_FALSE(scene.IsOccluded(
        origin, {-4, -1, 3}, 0, std::numeric_limits<double>::infinity()));
  }
}

TEST(RayScene, OutlivesItsMeshAndMoves) {
  RayScene moved = [] {
    RayScene scene(UnitQuad({0, 0, 0}));
    return scene;
  }();
  RayScene scene(UnitQuad({9, 9, 9}));
  scene = std::move(moved);
  EXPECT_TRUE(scene.FirstHit({0.5, 0.5, 2}, {0, 0, -2}).has_value());
}

TEST(RayScene, RefusesUnusableMeshes) {
  EXPECT_THROW(RayScene(IndexedMesh{}), InputError);
  IndexedMesh mesh = UnitQuad({0, 0, 0});
  mesh.triangles[1][2] = 4;
  EXPECT_THROW(RayScene{mesh}, InputError);
  mesh = UnitQuad({0, 0, 0});
  mesh.positions[2].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(RayScene{mesh}, InputError);
}

}  // namespace
}  // namespace octacut
