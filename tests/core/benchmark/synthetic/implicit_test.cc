#include "core/benchmark/synthetic/implicit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/benchmark/synthetic/beast_ewer.h"

namespace octacut {
namespace {

Eigen::Vector3d RandomIn(std::mt19937& rng, double extent) {
  std::uniform_real_distribution<double> uniform(-extent, extent);
  const double x = uniform(rng);
  const double y = uniform(rng);
  return {x, y, uniform(rng)};
}

const Eigen::Matrix3d kTurn =
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized())
        .toRotationMatrix();

std::vector<std::pair<const char*, ImplicitShape>> Shapes() {
  const ImplicitShape box = MakeBox({0.5, 0.4, 0.3}, 0.05);
  const ImplicitShape bar = MakeBar({0, 0, 0}, {0.8, 0.3, 0.1}, 0.2, 0.05);
  return {
      {"sphere", MakeSphere(0.7)},
      {"torus", MakeTorus(0.6, 0.2)},
      {"box", box},
      {"cylinder", MakeCylinder(0.5, 0.6, 0.1)},
      {"bar", bar},
      {"tube",
       MakeTube({{0, 0, 0, 0.2}, {0.5, 0.3, 0, 0.1}, {0.6, 0.9, 0.4, 0.15}})},
      {"union", Union({box, bar, Move(MakeSphere(0.3), {-0.6, 0, 0})}, 0.1)},
      {"intersect", Intersect(box, MakeSphere(0.5), 0.05)},
      {"subtract", Subtract(box, MakeSphere(0.35), 0.05)},
      {"rotate", Rotate(box, kTurn)},
      {"stretch", Stretch(MakeTorus(0.6, 0.2), {1.2, 0.7, 1})},
      {"displace",
       Displace(
           MakeSphere(0.7),
           [](const Eigen::Vector3d& p) { return 0.02 * std::sin(9 * p.x()); },
           0.02,
           0.18)},
      {"beast", MakeBeastEwer()}};
}

TEST(ImplicitShape, SlopesAreWithinTheirBound) {
  std::mt19937 rng(1);
  for (const auto& [name, shape] : Shapes()) {
    for (int trial = 0; trial < 3000; ++trial) {
      const Eigen::Vector3d a = RandomIn(rng, 1.3);
      const Eigen::Vector3d b = a + RandomIn(rng, trial % 2 ? 0.5 : 0.01);
      EXPECT_LE(std::abs(shape(a) - shape(b)),
                shape.lipschitz * (a - b).norm() + 1e-12)
          << name;
    }
  }
}

TEST(ImplicitShape, InsideIsInTheBoxAndTheValueBoundsItsDistance) {
  std::mt19937 rng(2);
  for (const auto& [name, shape] : Shapes()) {
    int num_inside = 0;
    for (int trial = 0; trial < 6000; ++trial) {
      const Eigen::Vector3d point = RandomIn(rng, 1.6);
      const double value = shape(point);
      num_inside += value < 0;
      const double distance =
          std::sqrt(shape.box.squaredExteriorDistance(point));
      if (distance > 0) {
        EXPECT_GE(value, shape.box_slope * distance - 1e-12) << name;
      }
    }
    EXPECT_GT(num_inside, 3) << name;
  }
}

TEST(ImplicitShape, PrimitivesAreDistances) {
  EXPECT_DOUBLE_EQ(MakeSphere(0.5)({0, 2, 0}), 1.5);
  EXPECT_DOUBLE_EQ(MakeTorus(1, 0.25)({0, 1, 1}), 0.75);
  EXPECT_DOUBLE_EQ(MakeBox({1, 2, 3}, 0.1)({0, 0, 5}), 2);
  EXPECT_DOUBLE_EQ(MakeBox({1, 2, 3}, 0.1)({0.5, 0, 0}), -0.5);
  EXPECT_DOUBLE_EQ(MakeCylinder(1, 2, 0.1)({3, 0, 0}), 2);
  EXPECT_DOUBLE_EQ(MakeCylinder(1, 2, 0.1)({0, 0, 2.5}), 0.5);
  EXPECT_DOUBLE_EQ(MakeBar({0, 0, 0}, {1, 0, 0}, 0.1, 0.1)({0.5, 1, 0}), 0.9);
}

TEST(ImplicitShape, TubeIsTheUnionOfItsBars) {
  const std::vector<Eigen::Vector4d> points{
      {0, 0, 0, 0.2}, {0.5, 0.3, 0, 0.1}, {0.6, 0.9, 0.4, 0.15}};
  const ImplicitShape tube = MakeTube(points, 1);
  const ImplicitShape bars =
      Union({MakeBar(points[0].head<3>(), points[1].head<3>(), 0.2, 0.1),
             MakeBar(points[1].head<3>(), points[2].head<3>(), 0.1, 0.15)});
  std::mt19937 rng(4);
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::Vector3d point = RandomIn(rng, 2);
    EXPECT_NEAR(tube(point), bars(point), 1e-12);
  }
}

TEST(ImplicitShape, CombinationsAreSetOperations) {
  const ImplicitShape a = MakeSphere(0.6);
  const ImplicitShape b = Move(MakeBox({0.4, 0.4, 0.4}, 0.05), {0.4, 0, 0});
  const ImplicitShape both = Union({a, b});
  const ImplicitShape common = Intersect(a, b);
  const ImplicitShape rest = Subtract(a, b);
  std::mt19937 rng(5);
  for (int trial = 0; trial < 2000; ++trial) {
    const Eigen::Vector3d p = RandomIn(rng, 1);
    EXPECT_EQ(both(p) < 0, a(p) < 0 || b(p) < 0);
    EXPECT_EQ(common(p) < 0, a(p) < 0 && b(p) < 0);
    EXPECT_EQ(rest(p) < 0, a(p) < 0 && -b(p) < 0);
  }
}

TEST(ImplicitShape, GradientPointsOutward) {
  const ImplicitShape sphere = MakeSphere(0.5);
  std::mt19937 rng(6);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Vector3d p = RandomIn(rng, 1);
    const Eigen::Vector3d gradient = ImplicitGradient(sphere, p, 1e-5);
    // The differences are of first order.
    EXPECT_LT((gradient - p.normalized()).norm(), 1e-5 / p.norm() + 1e-9);
  }
}

}  // namespace
}  // namespace octacut
