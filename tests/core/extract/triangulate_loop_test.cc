#include "core/extract/triangulate_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <Eigen/Geometry>
#include <map>
#include <set>

namespace octacut {
namespace {

TEST(TriangulateLoop, EnumeratesEveryTriangulationOnce) {
  // Catalan numbers.
  const std::map<int, size_t> counts = {{4, 2}, {6, 14}, {8, 132}};
  for (const auto& [size, count] : counts) {
    ASSERT_EQ(LoopTriangulations(size).size(), count * (size - 2));
    std::set<std::set<LoopTriangle>> distinct;
    for (size_t choice = 0; choice < count; ++choice) {
      const auto triangles = LoopTriangulation(size, int(choice));
      distinct.emplace(triangles.begin(), triangles.end());
      // Every side once along the loop, every chord once each way.
      std::map<std::pair<int, int>, int> directed;
      for (const LoopTriangle& t : triangles) {
        EXPECT_TRUE(t[0] < t[1] && t[1] < t[2]);
        ++directed[{t[0], t[1]}];
        ++directed[{t[1], t[2]}];
        ++directed[{t[2], t[0]}];
      }
      for (int i = 0; i < size; ++i) {
        EXPECT_EQ((directed[{i, (i + 1) % size}]), 1);
      }
      for (const auto& [edge, times] : directed) {
        EXPECT_EQ(times, 1);
        if ((edge.first + 1) % size != edge.second) {
          EXPECT_TRUE(directed.contains({edge.second, edge.first}));
        }
      }
    }
    EXPECT_EQ(distinct.size(), count);
  }
}

float SmallestArea(std::span<const Eigen::Vector3f> corners, int choice) {
  float smallest = 1e9f;
  for (const LoopTriangle& t : LoopTriangulation(int(corners.size()), choice)) {
    const Eigen::Vector3f a = corners[t[1]] - corners[t[0]];
    const Eigen::Vector3f b = corners[t[2]] - corners[t[0]];
    smallest = std::min(smallest, a.cross(b).norm() / 2);
  }
  return smallest;
}

TEST(TriangulateLoop, TakesTheShorterDiagonal) {
  const std::vector<Eigen::Vector3f> rhombus = {
      {-2, 0, 0}, {0, -1, 0}, {2, 0, 0}, {0, 1, 0}};
  const auto triangles = LoopTriangulation(4, ChooseTriangulation(rhombus));
  for (const LoopTriangle& t : triangles) {
    EXPECT_EQ(std::count(t.begin(), t.end(), 1), 1);
    EXPECT_EQ(std::count(t.begin(), t.end(), 3), 1);
  }
}

TEST(TriangulateLoop, AvoidsCollinearCorners) {
  // A plane at 45 degrees: two corners of the hexagon lie in the middle of a
  // side after placement.
  const std::vector<Eigen::Vector3f> hexagon = {
      {0, 1, 0}, {0, 1, 1}, {.5f, .5f, 1}, {1, 0, 1}, {1, 0, 0}, {.5f, .5f, 0}};
  EXPECT_GT(SmallestArea(hexagon, ChooseTriangulation(hexagon)), 0.3f);
}

TEST(TriangulateLoop, AcceptsCornersInOnePoint) {
  const std::vector<Eigen::Vector3f> point(8, Eigen::Vector3f::Ones());
  EXPECT_EQ(ChooseTriangulation(point), 0);
}

}  // namespace
}  // namespace octacut
