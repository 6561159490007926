#include "core/refine/surface_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

using testing::RefineScene;

TEST(SurfacePoints, AreApartAndCoverTheMesh) {
  const IndexedMesh mesh = Sphere(16, 1);
  const double distance = 0.2;
  const SurfacePoints points =
      SpreadPoints(mesh, RefineScene::Neighbors(mesh), distance);
  EXPECT_LT(points.vertices.size(), mesh.positions.size() / 3);
  EXPECT_TRUE(std::is_sorted(points.vertices.begin(), points.vertices.end()));
  const auto distance_to = [&](uint32_t vertex, size_t point) {
    return (mesh.positions[vertex] - mesh.positions[points.vertices[point]])
        .norm();
  };
  for (uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const size_t own = points.point_of[v];
    EXPECT_LE(distance_to(v, own), distance);
    for (size_t point = 0; point < points.vertices.size(); ++point) {
      EXPECT_LE(distance_to(v, own), distance_to(v, point));
      if (v == points.vertices[point]) {
        EXPECT_EQ(own, point);
      } else if (v == points.vertices[own]) {
        EXPECT_GT(distance_to(v, point), distance);
      }
    }
  }
}

TEST(SurfacePoints, AreNeighborsWhereTheirVerticesAre) {
  const IndexedMesh mesh = Sphere(10, 1);
  const VertexCorners neighbors = RefineScene::Neighbors(mesh);
  const SurfacePoints points = SpreadPoints(mesh, neighbors, 0.3);
  std::vector<std::set<uint32_t>> expected(points.vertices.size());
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    for (const uint32_t next : neighbors.Of(v)) {
      if (points.point_of[v] != points.point_of[next]) {
        expected[points.point_of[v]].insert(points.point_of[next]);
      }
    }
  }
  for (size_t point = 0; point < expected.size(); ++point) {
    const auto found = points.neighbors.Of(point);
    EXPECT_GE(found.size(), 3u);
    EXPECT_EQ(
        std::vector<uint32_t>(found.begin(), found.end()),
        std::vector<uint32_t>(expected[point].begin(), expected[point].end()));
  }
}

TEST(SurfacePoints, AreAllVerticesAtDistanceZero) {
  const IndexedMesh mesh = Sphere(6, 1);
  const SurfacePoints points =
      SpreadPoints(mesh, RefineScene::Neighbors(mesh), 0);
  EXPECT_EQ(points.vertices, testing::AllVertices(mesh));
  EXPECT_EQ(points.point_of, testing::AllVertices(mesh));
}

}  // namespace
}  // namespace octacut
