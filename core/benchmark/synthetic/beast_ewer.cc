#include "core/benchmark/synthetic/beast_ewer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace octacut {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

// 1 within [low, high], falling to 0 over `fall` beyond.
double Band(double x, double low, double high, double fall) {
  const double beyond = std::max({low - x, x - high, 0.0}) / fall;
  const double t = std::clamp(1 - beyond, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// A bump of height 1 around the origin, zero from distance 1 on.
double Bump(double distance_squared) {
  const double t = std::max(0.0, 1 - distance_squared);
  return t * t;
}

constexpr double kReliefBound = 0.03;
constexpr double kReliefSlope = 1.3;

// The vessel's relief: flutes around the belly, a row of bosses between two
// cords around the shoulder.
double VesselRelief(const Vector3d& p) {
  const double angle = std::atan2(p.y(), p.x());
  const double radius = std::hypot(p.x(), p.y());
  const double flutes = 0.011 * std::cos(22 * angle) *
                        Band(p.z(), -0.30, -0.02, 0.1) *
                        Band(radius, 0.3, 1, 0.1);
  double cords = 0;
  for (const double height : {0.09, 0.31}) {
    // Twisted: the thickness runs around in slanted strands.
    const double strands = std::cos(60 * angle + 100 * (p.z() - height));
    const double across = (p.z() - height) / 0.035;
    cords += (0.016 + 0.005 * strands) * Bump(across * across);
  }
  const double count = 24;
  const double turn = angle * count / (2 * std::numbers::pi);
  const double along =
      (turn - std::round(turn)) * 2 * std::numbers::pi / count * radius;
  const double across = p.z() - 0.2;
  const double bosses =
      0.026 * Bump((along * along + across * across) / (0.055 * 0.055));
  return flutes + cords + bosses;
}

ImplicitShape MakeVessel() {
  const ImplicitShape belly = Stretch(MakeSphere(1), {0.60, 0.54, 0.50});
  const ImplicitShape lip = MakeBar({0, 0, 0.25}, {0, 0, 0.85}, 0.37, 0.48);
  const ImplicitShape outer = Displace(
      Union({belly, lip}, 0.12), &VesselRelief, kReliefBound, kReliefSlope);
  const ImplicitShape cut = Move(MakeBox({2, 2, 2}, 0.02), {0, 0, 0.52 - 2});
  return Intersect(outer, cut, 0.02);
}

ImplicitShape MakeCavity() {
  return Union({Stretch(MakeSphere(1), {0.49, 0.44, 0.40}),
                MakeBar({0, 0, 0.25}, {0, 0, 0.95}, 0.31, 0.45)},
               0.12);
}

// The part of the beast with y > 0, and its mirror image.
void AddPair(std::vector<ImplicitShape>& parts,
             std::vector<Vector4d> points,
             int steps) {
  parts.push_back(MakeTube(points, steps));
  for (Vector4d& point : points) {
    point.y() = -point.y();
  }
  parts.push_back(MakeTube(points, steps));
}

ImplicitShape MakeHead() {
  std::vector<ImplicitShape> parts;
  parts.push_back(MakeTube({{0.40, 0, 0.05, 0.22},
                            {0.66, 0, 0.26, 0.165},
                            {0.80, 0, 0.50, 0.14},
                            {0.86, 0, 0.70, 0.15},
                            {1.00, 0, 0.70, 0.13},
                            {1.16, 0, 0.62, 0.09},
                            {1.24, 0, 0.58, 0.085}},
                           6));
  AddPair(parts,
          {{0.84, 0.08, 0.78, 0.05},
           {0.80, 0.20, 0.82, 0.055},
           {0.76, 0.32, 0.80, 0.03}},
          5);
  // Brows.
  AddPair(parts, {{1.02, 0.06, 0.80, 0.03}, {0.92, 0.13, 0.80, 0.03}}, 1);
  ImplicitShape head = Union(std::move(parts), 0.05);

  std::vector<ImplicitShape> eyes;
  for (const double side : {-1.0, 1.0}) {
    eyes.push_back(Move(MakeSphere(0.036), {0.985, side * 0.105, 0.745}));
  }
  head = Union({head, Union(std::move(eyes))}, 0.008);
  // Nostrils and mouth.
  std::vector<ImplicitShape> hollows;
  for (const double side : {-1.0, 1.0}) {
    hollows.push_back(Move(MakeSphere(0.024), {1.30, side * 0.042, 0.625}));
  }
  hollows.push_back(MakeTube({{1.10, 0.12, 0.56, 0.014},
                              {1.24, 0.085, 0.55, 0.014},
                              {1.325, 0, 0.555, 0.014},
                              {1.24, -0.085, 0.55, 0.014},
                              {1.10, -0.12, 0.56, 0.014}},
                             5));
  return Subtract(head, Union(std::move(hollows)), 0.012);
}

// A collar of beads around the neck, and a crest down its back.
ImplicitShape MakeTrimmings() {
  std::vector<ImplicitShape> beads;
  const Vector3d center(0.80, 0, 0.50);
  const Vector3d along = Vector3d(0.41, 0, 0.91).normalized();
  const Vector3d side = Vector3d::UnitY();
  const Vector3d forward = side.cross(along);
  constexpr int kNumBeads = 16;
  for (int i = 0; i < kNumBeads; ++i) {
    const double angle = 2 * std::numbers::pi * i / kNumBeads;
    beads.push_back(Move(
        MakeSphere(0.036),
        center + 0.135 * (std::cos(angle) * side + std::sin(angle) * forward)));
  }
  const double crest[][3] = {
      {0.765, 0.840, 0.045}, {0.715, 0.755, 0.045}, {0.690, 0.665, 0.042}};
  for (const auto& [x, z, radius] : crest) {
    beads.push_back(Move(MakeSphere(radius), {x, 0, z}));
  }
  return Union(std::move(beads));
}

ImplicitShape MakeAntlers() {
  std::vector<ImplicitShape> parts;
  AddPair(parts,
          {{0.84, 0.07, 0.80, 0.045},
           {0.76, 0.17, 0.98, 0.040},
           {0.66, 0.31, 1.14, 0.036},
           {0.68, 0.38, 1.36, 0.031}},
          6);
  AddPair(parts, {{0.74, 0.20, 1.02, 0.036}, {0.92, 0.27, 1.19, 0.030}}, 1);
  AddPair(parts, {{0.66, 0.31, 1.14, 0.034}, {0.49, 0.43, 1.24, 0.030}}, 1);
  return Union(std::move(parts), 0.03);
}

ImplicitShape MakeLegs() {
  std::vector<ImplicitShape> parts;
  AddPair(parts,
          {{0.34, 0.27, -0.20, 0.15},
           {0.42, 0.35, -0.46, 0.085},
           {0.37, 0.37, -0.74, 0.052},
           {0.43, 0.38, -0.92, 0.075}},
          6);
  AddPair(parts,
          {{-0.34, 0.27, -0.16, 0.17},
           {-0.50, 0.36, -0.42, 0.095},
           {-0.40, 0.37, -0.72, 0.050},
           {-0.36, 0.38, -0.92, 0.075}},
          6);
  const ImplicitShape ground = Move(MakeBox({2, 2, 2}, 0.01), {0, 0, 2 - 0.95});
  return Intersect(Union(std::move(parts)), ground, 0.015);
}

// The tail swings up to the rim: a handle. Its tuft curls outward.
ImplicitShape MakeTail() {
  return Union({MakeTube({{-0.48, 0, -0.02, 0.09},
                          {-0.80, 0, -0.02, 0.070},
                          {-0.98, 0, 0.20, 0.058},
                          {-0.90, 0, 0.48, 0.052},
                          {-0.66, 0, 0.56, 0.055},
                          {-0.43, 0, 0.44, 0.06}},
                         7),
                MakeTube({{-0.92, 0, 0.44, 0.045},
                          {-1.01, 0, 0.60, 0.05},
                          {-1.00, 0, 0.76, 0.045},
                          {-0.90, 0, 0.80, 0.035}},
                         6)},
               0.03);
}

}  // namespace

ImplicitShape MakeBeastEwer() {
  ImplicitShape body =
      Union({MakeVessel(), MakeLegs(), MakeTail(), MakeHead()}, 0.06);
  // The cavity after everything that grows into it.
  body = Subtract(std::move(body), MakeCavity(), 0.025);
  return Union({std::move(body), MakeAntlers(), MakeTrimmings()}, 0.012);
}

}  // namespace octacut
