// Where a lens distortion can be inverted, and its inverse.
// Private to this folder.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

#include "colmap_io/model/dual.h"
#include "colmap_io/model/lens_distortion.h"

namespace octacut::lens {

// The distorted radius r * RadialFactor(r^2) and its derivative by r.
template <typename Distortion>
Dual DistortedRadius(const double* k, double radius) {
  const Dual r(radius, 1, 0);
  return r * Distortion::RadialFactor(k, r * r);
}

template <typename Distortion>
bool GrowsAt(const double* k, double radius) {
  const Dual distorted = DistortedRadius<Distortion>(k, radius);
  return distorted.value >= 0 && distorted.dx > 0;
}

// The radius up to which the distorted radius grows; infinity when it does so
// up to 89.98 degrees off the axis. `is_angle`: radii are angles, at most pi.
template <typename Distortion>
double MaxRadius(const double* k, bool is_angle) {
  constexpr int kSteps = 4096;
  constexpr double kPi = std::numbers::pi;
  const auto radius_of = [&](double t) {  // of t in [0, 1)
    return is_angle ? kPi * t : std::tan(kPi / 2 * t);
  };
  const int last = std::is_same_v<Distortion, NoDistortion> ? 0 : kSteps - 1;
  for (int i = 1; i <= last; ++i) {
    double bad = radius_of(double(i) / kSteps);
    if (GrowsAt<Distortion>(k, bad)) continue;
    double good = radius_of(double(i - 1) / kSteps);
    for (int j = 0; j < 60; ++j) {
      const double middle = (good + bad) / 2;
      (GrowsAt<Distortion>(k, middle) ? good : bad) = middle;
    }
    return good;
  }
  return is_angle ? kPi : std::numeric_limits<double>::infinity();
}

// The radius in [0, max_radius] whose distorted radius is `target`, by Newton
// steps kept within a shrinking bracket; negative when there is none.
template <typename Distortion>
double InvertRadius(const double* k, double max_radius, double target) {
  if (target == 0) return 0;
  double low = 0;
  double high = max_radius;
  if (std::isinf(high)) {
    high = std::max(target, 1.0);
    while (DistortedRadius<Distortion>(k, high).value < target) {
      high *= 2;
      if (high > 1e6) return -1;
    }
  } else if (!(DistortedRadius<Distortion>(k, high).value >= target)) {
    return -1;
  }
  double radius = std::min(target, high);
  for (int i = 0; i < 200; ++i) {
    const Dual distorted = DistortedRadius<Distortion>(k, radius);
    (distorted.value > target ? high : low) = radius;
    double next = radius - (distorted.value - target) / distorted.dx;
    if (!(next >= low && next <= high)) next = (low + high) / 2;
    if (std::abs(next - radius) <= 1e-15 * next) return next;
    radius = next;
  }
  // Only where the derivative all but vanishes does Newton's method crawl.
  return radius;
}

// Newton's method in two dimensions from a start near the solution; false
// when it does not converge or ends where the distortion folds over.
template <typename Distortion>
bool RefineInverse(
    const double* k, double x_target, double y_target, double* u, double* v) {
  constexpr int kMaxIterations = 100;
  const double tolerance =
      1e-12 * (1 + std::abs(x_target) + std::abs(y_target));
  for (int i = 0; i < kMaxIterations; ++i) {
    Dual x, y;
    Distortion::Apply(k, Dual(*u, 1, 0), Dual(*v, 0, 1), &x, &y);
    const double error_x = x.value - x_target;
    const double error_y = y.value - y_target;
    const double determinant = x.dx * y.dy - x.dy * y.dx;
    if (std::abs(error_x) + std::abs(error_y) <= tolerance) {
      return determinant > 0;
    }
    double step_u = (y.dy * error_x - x.dy * error_y) / determinant;
    double step_v = (x.dx * error_y - y.dx * error_x) / determinant;
    const double length = std::hypot(step_u, step_v);
    if (!std::isfinite(length)) return false;
    // Keeps a step where the Jacobian is nearly singular from leaving the
    // basin of the solution.
    const double max_length = 0.1 * std::max(1.0, std::hypot(*u, *v));
    const double scale = length > max_length ? max_length / length : 1;
    *u -= scale * step_u;
    *v -= scale * step_v;
  }
  return false;
}

// Finds (u, v) with Distortion(u, v) = (x, y) and radius <= max_radius.
template <typename Distortion>
bool InvertDistortion(const double* k,
                      double max_radius,
                      double x,
                      double y,
                      double* u,
                      double* v) {
  const double target = std::hypot(x, y);
  if (!std::isfinite(target)) return false;
  double radius = InvertRadius<Distortion>(k, max_radius, target);
  if (Distortion::kIsRadial) {
    if (radius < 0) return false;
    const double scale = target > 0 ? radius / target : 1;
    *u = x * scale;
    *v = y * scale;
    return true;
  }
  // The radially symmetric part gives the start.
  if (radius < 0) radius = std::isinf(max_radius) ? target : max_radius;
  const double scale = target > 0 ? radius / target : 1;
  *u = x * scale;
  *v = y * scale;
  return RefineInverse<Distortion>(k, x, y, u, v) &&
         std::hypot(*u, *v) <= max_radius;
}

}  // namespace octacut::lens
