#include "core/mesh/exact_predicates.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>

namespace octacut {
namespace {

using Integer = boost::multiprecision::cpp_int;
using IntegerPoint = std::array<int64_t, 3>;

int Sign(const Integer& value) { return value.sign(); }

int IntegerOrient3d(const IntegerPoint& a,
                    const IntegerPoint& b,
                    const IntegerPoint& c,
                    const IntegerPoint& d) {
  std::array<std::array<Integer, 3>, 3> m;
  for (int axis = 0; axis < 3; ++axis) {
    m[0][axis] = Integer(a[axis]) - d[axis];
    m[1][axis] = Integer(b[axis]) - d[axis];
    m[2][axis] = Integer(c[axis]) - d[axis];
  }
  return Sign(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
              m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
              m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
}

// Scaled so that nothing is rounded.
Eigen::Vector3d ToPoint(const IntegerPoint& p) {
  return Eigen::Vector3d(static_cast<double>(p[0]),
                         static_cast<double>(p[1]),
                         static_cast<double>(p[2])) *
         0x1p-30;
}

int ProjectedOrient2d(const IntegerPoint& a,
                      const IntegerPoint& b,
                      const IntegerPoint& c,
                      int drop) {
  const int x = (drop + 1) % 3;
  const int y = (drop + 2) % 3;
  return Sign((Integer(a[x]) - c[x]) * (Integer(b[y]) - c[y]) -
              (Integer(a[y]) - c[y]) * (Integer(b[x]) - c[x]));
}

void ExpectExact(const std::array<IntegerPoint, 4>& p) {
  std::array<Eigen::Vector3d, 4> q;
  for (int i = 0; i < 4; ++i) {
    q[i] = ToPoint(p[i]);
  }
  EXPECT_EQ(Orient3d(q[0], q[1], q[2], q[3]),
            IntegerOrient3d(p[0], p[1], p[2], p[3]));
  EXPECT_EQ(Orient3d(q[1], q[0], q[2], q[3]),
            -IntegerOrient3d(p[0], p[1], p[2], p[3]));
  for (int drop = 0; drop < 3; ++drop) {
    EXPECT_EQ(Orient2d(q[0], q[1], q[2], drop),
              ProjectedOrient2d(p[0], p[1], p[2], drop));
  }
}

// Points in or hardly off a common plane or line, of very different sizes, so
// that differences do not fit into a double.
TEST(ExactPredicates, AgainstIntegers) {
  std::mt19937_64 random(3);
  const auto integer = [&](int bits) {
    return static_cast<int64_t>(random() >> (64 - bits)) -
           (int64_t{1} << (bits - 1));
  };
  size_t num_zero = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    std::array<IntegerPoint, 4> p;
    const int bits = 4 + static_cast<int>(random() % 40);
    for (int axis = 0; axis < 3; ++axis) {
      p[0][axis] = integer(bits);
      const int64_t u = integer(1 + static_cast<int>(random() % 6));
      const int64_t v = integer(1 + static_cast<int>(random() % 6));
      p[1][axis] = p[0][axis] + u;
      p[2][axis] = p[0][axis] + (trial % 3 == 0 ? 2 * u : v);
      p[3][axis] = p[0][axis] + 3 * u - 5 * v;
      if (trial % 2 == 0) {
        p[3][axis] *= 1 << (random() % 8);
      }
      if (trial % 5 == 0) {
        p[1][axis] = integer(50);
      }
    }
    ExpectExact(p);
    num_zero += IntegerOrient3d(p[0], p[1], p[2], p[3]) == 0;
  }
  EXPECT_GT(num_zero, 5000u);
  EXPECT_LT(num_zero, 15000u);
}

TEST(ExactPredicates, DifferencesThatRound) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 5000; ++trial) {
    // 53 bits at 2^52 and at 1: their difference has more than 53 bits.
    std::array<IntegerPoint, 4> p;
    const int64_t big = (int64_t{1} << 52) + static_cast<int64_t>(random() % 9);
    for (int axis = 0; axis < 3; ++axis) {
      p[0][axis] = big;
      p[1][axis] = -big + static_cast<int64_t>(random() % 3);
      p[2][axis] = static_cast<int64_t>(random() % 3);
      p[3][axis] = static_cast<int64_t>(random() % 3) - 1;
    }
    ExpectExact(p);
  }
}

}  // namespace
}  // namespace octacut
