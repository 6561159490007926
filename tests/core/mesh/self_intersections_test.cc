#include "core/mesh/self_intersections.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <random>

#include "core/base/error.h"
#include "core/mesh/triangle_intersection.h"
#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

SelfIntersections Find(const IndexedMesh& mesh, size_t max_examples = 0) {
  return FindSelfIntersections(mesh, Context(2), max_examples);
}

TEST(SelfIntersections, NoneOnCleanSurfaces) {
  for (const IndexedMesh& mesh :
       {Sphere(40),
        Potato(40),
        Cube(20),
        HeightField(50, [](double x, double y) { return std::sin(9 * x * y); }),
        Moved(Cube(12), {1e5, -3e4, 7e6}),
        IndexedMesh()}) {
    const SelfIntersections result = Find(mesh);
    EXPECT_EQ(result.num_pairs, 0u);
    EXPECT_EQ(result.num_triangles, 0u);
    EXPECT_EQ(result.num_left_out, 0u);
  }
}

TEST(SelfIntersections, UmbrellasThatTouchAreNone) {
  // Two cubes that share a corner, and two that share an edge, by position.
  EXPECT_EQ(Find(Joined(Cube(2), Moved(Cube(2), {1, 1, 1}))).num_pairs, 0u);
  EXPECT_EQ(Find(Joined(Cube(2), Moved(Cube(2), {1, 1, 0}))).num_pairs, 0u);
  // A whole side in common does overlap, each triangle once.
  EXPECT_GE(Find(Joined(Cube(2), Moved(Cube(2), {1, 0, 0}))).num_pairs, 8u);
}

TEST(SelfIntersections, PlantedCrossing) {
  IndexedMesh mesh = HeightField(10, [](double, double) { return 0; });
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  const auto planted = static_cast<uint32_t>(mesh.triangles.size());
  // Within one square's lower triangle.
  mesh.positions.insert(
      mesh.positions.end(),
      {{0.57, 0.52, -1}, {0.58, 0.53, -1}, {0.575, 0.525, 1}});
  mesh.triangles.push_back({first, first + 1, first + 2});
  const SelfIntersections result = Find(mesh, 10);
  EXPECT_EQ(result.num_pairs, 1u);
  EXPECT_EQ(result.num_triangles, 2u);
  // Row 5, column 5, of two triangles a square.
  EXPECT_THAT(
      result.examples,
      testing::ElementsAre(std::array<uint32_t, 2>{2 * (5 * 10 + 5), planted}));
}

TEST(SelfIntersections, DuplicateAndFoldedTriangles) {
  IndexedMesh mesh = HeightField(4, [](double, double) { return 0; });
  mesh.triangles.push_back(mesh.triangles[7]);
  SelfIntersections result = Find(mesh, 5);
  // With itself only: the neighbours of the copy are the original's.
  EXPECT_EQ(result.num_pairs, 1u);
  EXPECT_THAT(result.examples,
              testing::ElementsAre(std::array<uint32_t, 2>{7, 32}));
  // A vertex pulled over its opposite edges folds its fan.
  IndexedMesh folded = HeightField(4, [](double, double) { return 0; });
  folded.positions[2 * 5 + 2].x() += 0.4;
  EXPECT_GT(Find(folded).num_pairs, 0u);
}

TEST(SelfIntersections, DegenerateTrianglesAreLeftOut) {
  IndexedMesh mesh = Cube(3);
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({0, 1, 1});
  mesh.positions.emplace_back(NAN, 0, 0);
  mesh.triangles.push_back(
      {0, 1, static_cast<uint32_t>(mesh.positions.size() - 1)});
  const SelfIntersections result = Find(mesh);
  EXPECT_EQ(result.num_pairs, 0u);
  EXPECT_EQ(result.num_left_out, 3u);
}

TEST(SelfIntersections, AgainstAllPairsForAnyNumberOfThreads) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> uniform(0, 1);
  IndexedMesh mesh;
  for (uint32_t i = 0; i < 12000; ++i) {
    const Eigen::Vector3d center(
        uniform(random), uniform(random), uniform(random));
    for (uint32_t corner = 0; corner < 3; ++corner) {
      mesh.positions.push_back(center +
                               0.04 * Eigen::Vector3d(uniform(random),
                                                      uniform(random),
                                                      uniform(random)));
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const size_t num_checked = 2500;
  IndexedMesh few = mesh;
  few.triangles.resize(num_checked);
  std::vector<std::array<uint32_t, 2>> expected;
  const auto corners = [&](uint32_t i) {
    return TriangleCorners{mesh.positions[3 * i],
                           mesh.positions[3 * i + 1],
                           mesh.positions[3 * i + 2]};
  };
  for (uint32_t i = 0; i < num_checked; ++i) {
    for (uint32_t j = i + 1; j < num_checked; ++j) {
      if ((corners(i)[0] - corners(j)[0]).norm() < 0.2 &&
          TrianglesIntersect(corners(i), corners(j))) {
        expected.push_back({i, j});
      }
    }
  }
  EXPECT_GT(expected.size(), 20u);
  EXPECT_EQ(Find(few, 1000000).examples, expected);

  for (const uint32_t one_in : {1u, 10u, 100000u}) {
    std::vector<uint8_t> marked(num_checked);
    for (uint8_t& mark : marked) {
      mark = random() % one_in == 0 ? 1 : 0;
    }
    std::vector<std::array<uint32_t, 2>> of_marked;
    std::copy_if(
        expected.begin(),
        expected.end(),
        std::back_inserter(of_marked),
        [&](const auto& pair) { return marked[pair[0]] || marked[pair[1]]; });
    EXPECT_EQ(FindIntersectionsOfMarked(few, marked, Context(2)), of_marked);
  }

  const SelfIntersections one = FindSelfIntersections(mesh, Context(1), 7);
  EXPECT_EQ(one.examples.size(), 7u);
  for (const int threads : {2, 4}) {
    const SelfIntersections other =
        FindSelfIntersections(mesh, Context(threads), 7);
    EXPECT_EQ(one.num_pairs, other.num_pairs);
    EXPECT_EQ(one.num_triangles, other.num_triangles);
    EXPECT_EQ(one.examples, other.examples);
  }
}

TEST(SelfIntersections, IndexOutOfRange) {
  IndexedMesh mesh = Cube(1);
  mesh.triangles[3][2] = 8;
  EXPECT_THAT([&] { Find(mesh); },
              testing::ThrowsMessage<InputError>(
                  testing::HasSubstr("triangle 3: vertex index 8")));
}

}  // namespace
}  // namespace octacut
