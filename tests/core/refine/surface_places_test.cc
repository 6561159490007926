#include "core/refine/surface_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

using testing::RefineScene;

TEST(SurfacePlaces, AreApartAndCoverTheMesh) {
  const IndexedMesh mesh = Sphere(16, 1);
  const double distance = 0.2;
  const SurfacePlaces places =
      SpreadPlaces(mesh, RefineScene::Neighbors(mesh), distance);
  EXPECT_LT(places.vertices.size(), mesh.positions.size() / 3);
  EXPECT_TRUE(std::is_sorted(places.vertices.begin(), places.vertices.end()));
  const auto distance_to = [&](uint32_t vertex, size_t place) {
    return (mesh.positions[vertex] - mesh.positions[places.vertices[place]])
        .norm();
  };
  for (uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const size_t own = places.place_of[v];
    EXPECT_LE(distance_to(v, own), distance);
    for (size_t place = 0; place < places.vertices.size(); ++place) {
      EXPECT_LE(distance_to(v, own), distance_to(v, place));
      if (v == places.vertices[place]) {
        EXPECT_EQ(own, place);
      } else if (v == places.vertices[own]) {
        EXPECT_GT(distance_to(v, place), distance);
      }
    }
  }
}

TEST(SurfacePlaces, AreNeighborsWhereTheirVerticesAre) {
  const IndexedMesh mesh = Sphere(10, 1);
  const VertexCorners neighbors = RefineScene::Neighbors(mesh);
  const SurfacePlaces places = SpreadPlaces(mesh, neighbors, 0.3);
  std::vector<std::set<uint32_t>> expected(places.vertices.size());
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    for (const uint32_t next : neighbors.Of(v)) {
      if (places.place_of[v] != places.place_of[next]) {
        expected[places.place_of[v]].insert(places.place_of[next]);
      }
    }
  }
  for (size_t place = 0; place < expected.size(); ++place) {
    const auto found = places.neighbors.Of(place);
    EXPECT_GE(found.size(), 3u);
    EXPECT_EQ(
        std::vector<uint32_t>(found.begin(), found.end()),
        std::vector<uint32_t>(expected[place].begin(), expected[place].end()));
  }
}

TEST(SurfacePlaces, AreAllVerticesAtDistanceZero) {
  const IndexedMesh mesh = Sphere(6, 1);
  const SurfacePlaces places =
      SpreadPlaces(mesh, RefineScene::Neighbors(mesh), 0);
  EXPECT_EQ(places.vertices, testing::AllVertices(mesh));
  EXPECT_EQ(places.place_of, testing::AllVertices(mesh));
}

}  // namespace
}  // namespace octacut
