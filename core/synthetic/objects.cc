#include "core/synthetic/objects.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/check_option.h"
#include "core/synthetic/beast_ewer.h"
#include "core/synthetic/drapery.h"

namespace octacut {

void ObjectParameters::Check() const {
  CheckOption(cup_depth > 0.05 && cup_depth <= 2,
              "cup_depth",
              cup_depth,
              "must be in (0.05, 2]");
  CheckOption(rod_radius >= 0.005 && rod_radius <= 0.3,
              "rod_radius",
              rod_radius,
              "must be in [0.005, 0.3]");
  // Thicker ones would grow together.
  CheckOption(finger_radius >= 0.005 && finger_radius <= 0.08,
              "finger_radius",
              finger_radius,
              "must be in [0.005, 0.08]");
  CheckOption(fold_width >= 0.02 && fold_width <= 0.2,
              "fold_width",
              fold_width,
              "must be in [0.02, 0.2]");
  CheckOption(fold_depth >= 0.5 && fold_depth * fold_width <= 0.38,
              "fold_depth",
              fold_depth,
              "must be at least 0.5, and 0.38 / fold_width at most");
}

namespace {

Eigen::Matrix3d Tilt(double degrees, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized())
      .toRotationMatrix();
}

SyntheticObject MakeRotatedBox() {
  return {Rotate(MakeBox({0.8, 0.6, 0.45}, 0.03), Tilt(35, {1, 2, 3}))};
}

SyntheticObject MakeCup(double depth_in_diameters) {
  const double cavity_radius = 0.5;
  const double wall = 0.15;
  const double depth = 2 * cavity_radius * depth_in_diameters;
  const double half_height = (depth + wall) / 2;
  const double rounding = 0.04;
  // The cavity's cylinder reaches out of the top by as much again.
  const ImplicitShape cavity =
      Move(MakeCylinder(cavity_radius, depth, rounding), {0, 0, half_height});
  return {Subtract(MakeCylinder(cavity_radius + wall, half_height, rounding),
                   cavity,
                   rounding)};
}

SyntheticObject MakeRods(double radius) {
  const ImplicitShape rod = MakeBar({-0.9, 0, 0}, {0.9, 0, 0}, radius, radius);
  const Eigen::Matrix3d tilt = Tilt(20, {1, 1, 0.3});
  std::vector<ImplicitShape> rods;
  for (const Eigen::Matrix3d& turn : {Tilt(0, Eigen::Vector3d::UnitZ()),
                                      Tilt(90, Eigen::Vector3d::UnitZ()),
                                      Tilt(90, Eigen::Vector3d::UnitY())}) {
    rods.push_back(Rotate(rod, tilt * turn));
  }
  return {Union(std::move(rods), radius)};
}

SyntheticObject MakeFingers(double tip_radius) {
  const double scale = tip_radius / 0.065;
  std::vector<ImplicitShape> parts;
  parts.push_back(Move(MakeBox({0.5, 0.16, 0.4}, 0.14), {0, 0, -0.45}));
  const double lengths[] = {0.72, 0.85, 0.8, 0.6};
  for (int i = 0; i < 4; ++i) {
    const double x = -0.39 + 0.26 * i;
    parts.push_back(MakeBar({x, 0, -0.15},
                            {1.5 * x, -0.05, -0.15 + lengths[i]},
                            0.1 * scale,
                            tip_radius));
  }
  parts.push_back(MakeTube({{0.35, 0, -0.6, 0.12 * scale},
                            {0.6, -0.1, -0.4, 0.11 * scale},
                            {0.78, -0.25, -0.1, 0.075 * scale}}));
  return {Union(std::move(parts), 0.06 * std::min(scale, 1.0))};
}

SyntheticObject MakeTouchingSpheres() {
  return {Union({Move(MakeSphere(0.5), {-0.495, 0, 0}),
                 Move(MakeSphere(0.5), {0.495, 0, 0})},
                0.1)};
}

// Broad folds, and relief of a few hundredths on them, whose slopes stay within
// the bounds that Displace is told.
double LumpRelief(const Eigen::Vector3d& p) {
  return 0.05 * std::sin(5 * p.x() + 2 * p.z()) * std::sin(4 * p.z() - p.y()) +
         0.012 * std::sin(17 * p.x()) * std::sin(15 * p.y() + 3 * p.x()) *
             std::sin(16 * p.z() + 2);
}

SyntheticObject MakeLump() {
  const ImplicitShape body =
      Union({Stretch(MakeSphere(1), {0.62, 0.7, 0.85}),
             Move(MakeBar({0, 0, 0}, {0.3, 0, 0}, 0.22, 0.12), {0.5, 0, 0.1}),
             Move(MakeSphere(0.3), {-0.35, 0.5, 0.45})},
            0.2);
  return {Displace(body, &LumpRelief, 0.062, 1.1)};
}

SyntheticObject MakeVase() {
  const ImplicitShape body =
      Union({Move(Stretch(MakeSphere(1), {0.55, 0.55, 0.6}), {0, 0, -0.2}),
             MakeBar({0, 0, 0.3}, {0, 0, 0.9}, 0.22, 0.36),
             MakeBar({0, 0, -0.85}, {0, 0, -0.6}, 0.4, 0.3)},
            0.15);
  const ImplicitShape opening = MakeBar({0, 0, 0.4}, {0, 0, 1.1}, 0.12, 0.34);
  return {Subtract(
      Intersect(body, MakeBox({2, 2, 0.85}, 0.01), 0.02), opening, 0.03)};
}

}  // namespace

SyntheticObject MakeObject(std::string_view name,
                           const ObjectParameters& parameters) {
  parameters.Check();
  if (name == "sphere") {
    return {MakeSphere(0.8)};
  }
  if (name == "torus") {
    return {Rotate(MakeTorus(0.65, 0.25), Tilt(30, {1, 0.2, 0})), 1};
  }
  if (name == "box") {
    return MakeRotatedBox();
  }
  if (name == "cup") {
    return MakeCup(parameters.cup_depth);
  }
  if (name == "rods") {
    return MakeRods(parameters.rod_radius);
  }
  if (name == "fingers") {
    return MakeFingers(parameters.finger_radius);
  }
  if (name == "touching_spheres") {
    return MakeTouchingSpheres();
  }
  if (name == "lump") {
    return MakeLump();
  }
  if (name == "drapery") {
    return {MakeDrapery({.max_width = parameters.fold_width,
                         .min_width = parameters.fold_width / 5,
                         .depth = parameters.fold_depth})};
  }
  if (name == "vase") {
    return MakeVase();
  }
  if (name == "example") {
    return {MakeBeastEwer(), 1};
  }
  throw OptionError(fmt::format("object = {}: unknown", name));
}

std::vector<std::string> ObjectNames() {
  return {"sphere",
          "torus",
          "box",
          "cup",
          "rods",
          "fingers",
          "touching_spheres",
          "lump",
          "drapery",
          "vase",
          "example"};
}

}  // namespace octacut
