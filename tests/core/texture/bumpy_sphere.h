// A sphere with bumps whose normals have a closed form.
#pragma once

#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <vector>

#include "tests/core/texture/small_sphere.h"

namespace octacut::testing {

// The bumpy sphere r(u) = 1 + sum of kBumpHeight exp(kBumpNarrow (u . c - 1))
// over the centres c: bumps of 10 degrees, whose sides are inclined by up to 6
// degrees.
inline constexpr double kBumpHeight = 0.03;
inline constexpr double kBumpNarrow = 30;

inline const std::vector<Eigen::Vector3d>& BumpCenters() {
  static const std::vector<Eigen::Vector3d> kCenters = [] {
    std::vector<Eigen::Vector3d> result;
    for (const Eigen::Vector3d& direction : AllAround()) {
      result.push_back(direction.normalized());
    }
    return result;
  }();
  return kCenters;
}

inline double BumpyRadius(const Eigen::Vector3d& u) {
  double radius = 1;
  for (const Eigen::Vector3d& c : BumpCenters()) {
    radius += kBumpHeight * std::exp(kBumpNarrow * (u.dot(c) - 1));
  }
  return radius;
}

// The gradient of |p| - r(p / |p|).
inline Eigen::Vector3d BumpyNormal(const Eigen::Vector3d& u) {
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& c : BumpCenters()) {
    slope += kBumpHeight * kBumpNarrow *
             std::exp(kBumpNarrow * (u.dot(c) - 1)) * (c - u.dot(c) * u);
  }
  return (u - slope / BumpyRadius(u)).normalized();
}

inline IndexedMesh BumpySphere() {
  IndexedMesh mesh = SmallSphere(6);
  for (Eigen::Vector3d& p : mesh.positions) {
    p *= BumpyRadius(p);
  }
  return mesh;
}

inline double Degrees(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

}  // namespace octacut::testing
