#include "core/print/polygon_triangles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace octacut {
namespace {

using Points = std::vector<Eigen::Vector2d>;

double TwiceAreaOf(const Points& points, const std::array<uint32_t, 3>& t) {
  const Eigen::Vector2d b = points[t[1]] - points[t[0]];
  const Eigen::Vector2d c = points[t[2]] - points[t[0]];
  return b.x() * c.y() - b.y() * c.x();
}

// Appends a regular polygon; clockwise where `radius` is negative.
PolygonLoop AddCircle(const Eigen::Vector2d& center,
                      double radius,
                      uint32_t count,
                      Points* points) {
  PolygonLoop loop;
  for (uint32_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    loop.push_back(uint32_t(points->size()));
    points->push_back(center +
                      std::abs(radius) *
                          Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  if (radius < 0) {
    std::reverse(loop.begin(), loop.end());
  }
  return loop;
}

// Every triangle has an area, every edge of a loop is there once, every other
// edge twice, in both directions; the areas add up.
void ExpectFilled(const Points& points,
                  const std::vector<PolygonLoop>& loops,
                  double area) {
  const auto triangles = TrianglesOfLoops(points, loops);
  ASSERT_FALSE(triangles.empty());
  std::multiset<std::pair<uint32_t, uint32_t>> edges;
  double sum = 0;
  for (const auto& triangle : triangles) {
    const double twice_area = TwiceAreaOf(points, triangle);
    EXPECT_GT(twice_area, 0);
    sum += twice_area / 2;
    for (int i = 0; i < 3; ++i) {
      edges.insert({triangle[i], triangle[(i + 1) % 3]});
    }
  }
  EXPECT_NEAR(sum, area, 1e-9 * area);
  for (const PolygonLoop& loop : loops) {
    for (size_t i = 0; i < loop.size(); ++i) {
      const uint32_t a = loop[i];
      const uint32_t b = loop[(i + 1) % loop.size()];
      EXPECT_EQ(edges.count({a, b}), 1u);
      EXPECT_EQ(edges.count({b, a}), 0u);
      edges.erase({a, b});
    }
  }
  for (const auto& [a, b] : edges) {
    EXPECT_EQ(edges.count({b, a}), 1u) << a << " " << b;
  }
}

TEST(TrianglesOfLoops, CornersInLineAreUsed) {
  Points points;
  PolygonLoop square;
  const std::vector<Eigen::Vector2d> corners = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i < 4; ++i) {
      square.push_back(uint32_t(points.size()));
      points.push_back(corners[side] +
                       i * 0.25 * (corners[(side + 1) % 4] - corners[side]));
    }
  }
  ExpectFilled(points, {square}, 16);
}

TEST(TrianglesOfLoops, NestedLoops) {
  Points points;
  std::vector<PolygonLoop> loops;
  double area = 0;
  const auto add = [&](double x, double y, double radius, uint32_t count) {
    loops.push_back(AddCircle({x, y}, radius, count, &points));
    area += (radius > 0 ? 0.5 : -0.5) * count * radius * radius *
            std::sin(2 * std::numbers::pi / count);
  };
  // A disc with four holes, of which one has an island with a hole, and
  // another disc beside it.
  add(0, 0, 10, 60);
  add(-5, 0, -3, 31);
  add(5, 0, -3, 30);
  add(0, 5, -1.5, 4);
  add(0, -5, -1.5, 5);
  add(5, 0, 2, 17);
  add(5, 0, -1, 7);
  add(30, 3, 8, 12);
  ExpectFilled(points, loops, area);
}

// Holes side by side at the same height, whose corners hide one another.
TEST(TrianglesOfLoops, ManyHolesInARow) {
  Points points = {{0, 0}, {21, 0}, {21, 3}, {0, 3}};
  std::vector<PolygonLoop> loops = {{0, 1, 2, 3}};
  for (int i = 0; i < 10; ++i) {
    const auto first = uint32_t(points.size());
    const double x = 1 + 2 * i;
    points.insert(points.end(), {{x, 1}, {x, 2}, {x + 1, 2}, {x + 1, 1}});
    loops.push_back({first, first + 1, first + 2, first + 3});
  }
  ExpectFilled(points, loops, 63 - 10);
}

TEST(TrianglesOfLoops, ASpiral) {
  Points points;
  PolygonLoop loop;
  const auto add = [&](double radius, double angle) {
    loop.push_back(uint32_t(points.size()));
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  };
  constexpr int kCount = 300;
  for (int i = 0; i < kCount; ++i) {
    add(1 + 0.05 * i, 0.1 * i);
  }
  for (int i = kCount; i-- > 0;) {
    add(0.5 + 0.05 * i, 0.1 * i);
  }
  double area = 0;
  for (size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector2d& p = points[i];
    const Eigen::Vector2d& q = points[(i + 1) % points.size()];
    area += (p.x() * q.y() - p.y() * q.x()) / 2;
  }
  if (area < 0) {
    std::reverse(loop.begin(), loop.end());
  }
  ExpectFilled(points, {loop}, std::abs(area));
}

TEST(TrianglesOfLoops, LoopsThatMeetAreRefused) {
  // A hole without anything around it.
  Points points;
  const PolygonLoop hole = AddCircle({0, 0}, -1, 8, &points);
  EXPECT_TRUE(TrianglesOfLoops(points, {hole}).empty());
  // A figure of eight.
  const Points eight = {{0, 0}, {2, 2}, {2, 0}, {0, 1}};
  EXPECT_TRUE(TrianglesOfLoops(eight, {{0, 1, 2, 3}}).empty());
}

}  // namespace
}  // namespace octacut
