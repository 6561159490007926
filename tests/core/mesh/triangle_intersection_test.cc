#include "core/mesh/triangle_intersection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <Eigen/Geometry>
#include <random>

namespace octacut {
namespace {

using Corner = Eigen::Matrix<int64_t, 3, 1>;

TriangleCorners Triangle(const Eigen::Vector3d& a,
                         const Eigen::Vector3d& b,
                         const Eigen::Vector3d& c) {
  return {a, b, c};
}

// In every order of the corners and of the two.
void ExpectIntersect(bool expected,
                     const TriangleCorners& first,
                     const TriangleCorners& second) {
  std::array<int, 3> order = {0, 1, 2};
  do {
    const TriangleCorners turned = {
        first[order[0]], first[order[1]], first[order[2]]};
    EXPECT_EQ(TrianglesIntersect(turned, second), expected);
    EXPECT_EQ(TrianglesIntersect(second, turned), expected);
  } while (std::next_permutation(order.begin(), order.end()));
}

const TriangleCorners kBase = Triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});

TEST(TrianglesIntersect, Separate) {
  ExpectIntersect(false, kBase, Triangle({0, 0, 1}, {4, 0, 1}, {0, 4, 1}));
  ExpectIntersect(false, kBase, Triangle({5, 0, 0}, {9, 0, 0}, {5, 4, 0}));
  ExpectIntersect(false, kBase, Triangle({3, 3, -1}, {3, 3, 1}, {9, 9, 0}));
}

TEST(TrianglesIntersect, CrossAndTouch) {
  // Through the inside, an edge on the plane, a corner on the face, an edge
  // across an edge.
  ExpectIntersect(true, kBase, Triangle({1, 1, -1}, {1, 1, 1}, {9, 9, 0}));
  ExpectIntersect(true, kBase, Triangle({1, 1, 0}, {2, 1, 0}, {1, 1, 3}));
  ExpectIntersect(true, kBase, Triangle({1, 1, 0}, {1, 2, 3}, {2, 1, 3}));
  ExpectIntersect(true, kBase, Triangle({2, 0, -1}, {2, 0, 1}, {2, -5, 0}));
}

TEST(TrianglesIntersect, InOnePlane) {
  ExpectIntersect(true, kBase, Triangle({1, 1, 0}, {2, 1, 0}, {1, 2, 0}));
  ExpectIntersect(true, kBase, Triangle({-1, 1, 0}, {9, 1, 0}, {9, 2, 0}));
  ExpectIntersect(true, kBase, Triangle({-9, -9, 0}, {99, 0, 0}, {0, 99, 0}));
  ExpectIntersect(true, kBase, Triangle({2, 2, 0}, {9, 2, 0}, {9, 9, 0}));
}

TEST(TrianglesIntersect, SharedEdge) {
  const TriangleCorners opposite = Triangle({0, 0, 0}, {4, 0, 0}, {1, -4, 0});
  ExpectIntersect(false, kBase, opposite);
  ExpectIntersect(false, kBase, Triangle({0, 0, 0}, {4, 0, 0}, {1, 1, 1e-9}));
  ExpectIntersect(true, kBase, Triangle({0, 0, 0}, {4, 0, 0}, {1, 1, 0}));
  ExpectIntersect(true, kBase, Triangle({0, 0, 0}, {4, 0, 0}, {-9, 9, 0}));
  ExpectIntersect(true, kBase, kBase);
}

TEST(TrianglesIntersect, SharedVertex) {
  ExpectIntersect(false, kBase, Triangle({0, 0, 0}, {-1, 0, 0}, {0, -1, 0}));
  ExpectIntersect(false, kBase, Triangle({0, 0, 0}, {1, 1, 1}, {2, 1, 1}));
  ExpectIntersect(false, kBase, Triangle({0, 0, 0}, {-2, 1, 1}, {1, -2, -1}));
  // Crosses the inside, lies along an edge, overlaps in the plane.
  ExpectIntersect(true, kBase, Triangle({0, 0, 0}, {1, 2, 1}, {2, 1, -1}));
  ExpectIntersect(true, kBase, Triangle({0, 0, 0}, {2, 0, 0}, {1, 0, 3}));
  ExpectIntersect(true, kBase, Triangle({0, 0, 0}, {8, 0, 0}, {1, 0, 3}));
  ExpectIntersect(true, kBase, Triangle({0, 0, 0}, {1, 1, 0}, {2, 1, 0}));
  ExpectIntersect(true, kBase, Triangle({0, 0, 0}, {5, 5, 0}, {5, -5, 0}));
}

TEST(IsDegenerate, Collinear) {
  EXPECT_FALSE(IsDegenerate(kBase));
  EXPECT_TRUE(IsDegenerate(Triangle({1, 2, 3}, {1, 2, 3}, {4, 5, 6})));
  EXPECT_TRUE(IsDegenerate(Triangle({0, 0, 0}, {1, 2, 3}, {3, 6, 9})));
  EXPECT_FALSE(
      IsDegenerate(Triangle({0, 0, 0}, {1, 2, 3}, {3, 6, 9 + 1e-15})) &&
      IsDegenerate(Triangle({0, 0, 0}, {1, 2, 3}, {3, 6, 9 + 4e-15})));
}

// Closed convex sets with integer corners are apart if and only if one of
// these directions has a gap: another method than the one under test.
bool AreApart(const std::vector<Corner>& first,
              const std::vector<Corner>& second) {
  // The offset matters to parallel segments alone.
  std::vector<Corner> edges = {second[0] - first[0]};
  std::vector<Corner> axes;
  for (const std::vector<Corner>& set : {first, second}) {
    for (size_t i = 0; i < set.size(); ++i) {
      edges.push_back(set[(i + 1) % set.size()] - set[i]);
    }
    if (set.size() == 3) {
      axes.push_back((set[1] - set[0]).cross(set[2] - set[0]));
    }
  }
  for (const Corner& edge : edges) {
    for (const Corner& other : edges) {
      axes.push_back(edge.cross(other));
    }
  }
  // Within a plane or a line.
  for (const Corner& normal : std::vector<Corner>(axes)) {
    for (const Corner& edge : edges) {
      axes.push_back(normal.cross(edge));
    }
  }
  axes.insert(axes.end(), edges.begin(), edges.end());
  for (const Corner& axis : axes) {
    const auto range = [&](const std::vector<Corner>& set) {
      int64_t low = INT64_MAX;
      int64_t high = INT64_MIN;
      for (const Corner& corner : set) {
        low = std::min(low, axis.dot(corner));
        high = std::max(high, axis.dot(corner));
      }
      return std::pair(low, high);
    };
    const auto [low_1, high_1] = range(first);
    const auto [low_2, high_2] = range(second);
    if (high_1 < low_2 || high_2 < low_1) {
      return true;
    }
  }
  return false;
}

// By the definition in the header, with the shared corners in front.
bool BruteForceIntersect(const std::vector<Corner>& a,
                         const std::vector<Corner>& b,
                         size_t num_shared) {
  switch (num_shared) {
    case 0:
      return !AreApart(a, b);
    case 1:
      return !AreApart({a[1], a[2]}, b) || !AreApart({b[1], b[2]}, a);
    case 2:
      // Beside the shared edge: the opposite corner, or its edges.
      return !AreApart({a[2]}, b) || !AreApart({b[2]}, a) ||
             !AreApart({a[0], a[2]}, {b[1], b[2]}) ||
             !AreApart({a[1], a[2]}, {b[0], b[2]});
    default:
      return true;
  }
}

TEST(TrianglesIntersect, AgainstSeparatingAxesOnASmallGrid) {
  std::mt19937 random(17);
  std::array<std::array<size_t, 2>, 3> seen = {};
  for (int trial = 0; trial < 60000; ++trial) {
    const size_t num_shared = random() % 3;
    const int side = 2 + static_cast<int>(random() % 4);
    const auto corner = [&] {
      return Corner(random() % side, random() % side, random() % side);
    };
    std::vector<Corner> a = {corner(), corner(), corner()};
    std::vector<Corner> b = {corner(), corner(), corner()};
    std::copy_n(a.begin(), num_shared, b.begin());
    size_t num_equal = 0;
    for (const Corner& p : a) {
      num_equal += std::count(b.begin(), b.end(), p);
    }
    const auto is_flat = [](const std::vector<Corner>& t) {
      return (t[1] - t[0]).cross(t[2] - t[0]).isZero();
    };
    if (is_flat(a) || is_flat(b) || num_equal != num_shared) {
      continue;
    }
    // Steps of a third and a far origin: nothing is round in binary.
    const auto to_triangle = [](const std::vector<Corner>& t) {
      return Triangle(t[0].cast<double>() * 0.375,
                      t[1].cast<double>() * 0.375,
                      t[2].cast<double>() * 0.375);
    };
    const bool expected = BruteForceIntersect(a, b, num_shared);
    ++seen[num_shared][expected];
    ASSERT_EQ(TrianglesIntersect(to_triangle(a), to_triangle(b)), expected)
        << num_shared;
  }
  for (const std::array<size_t, 2>& both : seen) {
    EXPECT_GT(both[0], 100u);
    EXPECT_GT(both[1], 100u);
  }
}

}  // namespace
}  // namespace octacut
