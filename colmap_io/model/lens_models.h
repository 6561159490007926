// The projection of each family of COLMAP's camera models, as static
// functions over prepared intrinsics. Each model has
//   Prepare(intrinsics)  sets max_radius from the distortion
//   Project(intrinsics, u, v, w, &x, &y)  ray -> pixel
//   Unproject(intrinsics, x, y, &ray)  pixel -> ray of any length
// Project and Unproject return whether they succeeded and write their result
// in any case (it is then meaningless), so that rows of them can be
// vectorized.
//
// Private to this folder.
#pragma once

#include <cmath>
#include <Eigen/Core>
#include <limits>
#include <numbers>

#include "colmap_io/model/camera_projector.h"
#include "colmap_io/model/lens_distortion.h"
#include "colmap_io/model/lens_inverse.h"

namespace octacut::lens {

// As COLMAP: rays with a smaller z do not project. It depends on the ray's
// length; kept for the same answers.
inline constexpr double kMinDepth = std::numeric_limits<double>::epsilon();

inline void Normalize(
    const CameraIntrinsics& in, double x, double y, double* u, double* v) {
  *u = (x - in.cx) / in.fx;
  *v = (y - in.cy) / in.fy;
}

inline void ToPixel(
    const CameraIntrinsics& in, double u, double v, double* x, double* y) {
  *x = in.fx * u + in.cx;
  *y = in.fy * v + in.cy;
}

// atan2(rho, w) for rho >= 0 to 2e-14, in operations that are vectorized: the
// angle is halved three times, tan(a / 2) = tan(a) / (1 + sqrt(1 + tan(a)^2)),
// and then small enough for the series.
inline double AngleOffAxis(double rho, double w) {
  constexpr double kPi = std::numbers::pi;
  const double half = rho / (std::sqrt(rho * rho + w * w) + std::abs(w));
  const double quarter = half / (1 + std::sqrt(1 + half * half));
  const double t = quarter / (1 + std::sqrt(1 + quarter * quarter));
  const double s = t * t;
  double series = 1. / 17;
  series = 1. / 15 - s * series;
  series = 1. / 13 - s * series;
  series = 1. / 11 - s * series;
  series = 1. / 9 - s * series;
  series = 1. / 7 - s * series;
  series = 1. / 5 - s * series;
  series = 1. / 3 - s * series;
  const double angle = 8 * t * (1 - s * series);
  return w >= 0 ? angle : kPi - angle;
}

// Distortion of normalized coordinates: models 0-4 and 6.
template <typename Distortion>
struct PerspectiveModel {
  static void Prepare(CameraIntrinsics* in) {
    in->max_radius = MaxRadius<Distortion>(in->extra.data(), false);
  }
  static bool Project(const CameraIntrinsics& in,
                      double u,
                      double v,
                      double w,
                      double* x,
                      double* y) {
    const double a = u / w;
    const double b = v / w;
    double xd, yd;
    Distortion::Apply(in.extra.data(), a, b, &xd, &yd);
    ToPixel(in, xd, yd, x, y);
    return (w >= kMinDepth) & (a * a + b * b <= in.max_radius * in.max_radius);
  }
  static bool Unproject(const CameraIntrinsics& in,
                        double x,
                        double y,
                        Eigen::Vector3d* ray) {
    double xd, yd;
    Normalize(in, x, y, &xd, &yd);
    ray->z() = 1;
    return InvertDistortion<Distortion>(
        in.extra.data(), in.max_radius, xd, yd, &ray->x(), &ray->y());
  }
};

// Distortion of the direction scaled by the angle off the axis (equidistant
// fisheye): models 5, 8-11, 14, 15.
template <typename Distortion>
struct FisheyeModel {
  static void Prepare(CameraIntrinsics* in) {
    in->max_radius = MaxRadius<Distortion>(in->extra.data(), true);
  }
  static bool Project(const CameraIntrinsics& in,
                      double u,
                      double v,
                      double w,
                      double* x,
                      double* y) {
    const double rho = std::sqrt(u * u + v * v);
    const double theta = AngleOffAxis(rho, w);
    // On the axis theta / rho tends to 1 / w.
    const double scale = rho > 1e-12 * w ? theta / rho : 1 / w;
    double xd, yd;
    Distortion::Apply(in.extra.data(), scale * u, scale * v, &xd, &yd);
    ToPixel(in, xd, yd, x, y);
    return ((rho > 0) | (w >= kMinDepth)) & (theta <= in.max_radius);
  }
  static bool Unproject(const CameraIntrinsics& in,
                        double x,
                        double y,
                        Eigen::Vector3d* ray) {
    double xd, yd, a, b;
    Normalize(in, x, y, &xd, &yd);
    if (!InvertDistortion<Distortion>(
            in.extra.data(), in.max_radius, xd, yd, &a, &b)) {
      return false;
    }
    const double theta = std::hypot(a, b);
    const double scale = theta > 1e-12 ? std::sin(theta) / theta : 1;
    *ray = {a * scale, b * scale, std::cos(theta)};
    return true;
  }
};

// Devernay & Faugeras 2001; extra: omega and, prepared, 2 tan(omega / 2).
struct FOVModel {
  // COLMAP's thresholds for its series expansions, on squares.
  static constexpr double kSmall = 1e-4;

  static void Prepare(CameraIntrinsics* in) {
    in->extra[0] = std::abs(in->extra[0]);  // the formula is even in omega
    in->extra[1] = 2 * std::tan(in->extra[0] / 2);
  }

  // Distorted over undistorted radius.
  static double Factor(double omega, double tangent, double radius2) {
    const double omega2 = omega * omega;
    // For small omega COLMAP uses the series of the inverse here. Its
    // cameras were estimated with that, so it is their meaning.
    if (omega2 < kSmall) return omega2 * radius2 / 3 - omega2 / 12 + 1;
    const double radius = std::sqrt(radius2);
    const double near = tangent / omega * (1 - radius2 * tangent * tangent / 3);
    const double far = AngleOffAxis(radius * tangent, 1) / (radius * omega);
    return radius2 < kSmall ? near : far;
  }
  static bool Project(const CameraIntrinsics& in,
                      double u,
                      double v,
                      double w,
                      double* x,
                      double* y) {
    const double a = u / w;
    const double b = v / w;
    const double factor = Factor(in.extra[0], in.extra[1], a * a + b * b);
    ToPixel(in, a * factor, b * factor, x, y);
    return w >= kMinDepth;
  }
  static bool Unproject(const CameraIntrinsics& in,
                        double x,
                        double y,
                        Eigen::Vector3d* ray) {
    const double omega = in.extra[0];
    const double tangent = in.extra[1];
    double xd, yd;
    Normalize(in, x, y, &xd, &yd);
    const double distorted = std::hypot(xd, yd);
    double radius = distorted;
    if (omega * omega < kSmall) {
      // radius * Factor = distorted, a contraction since omega is small.
      for (int i = 0; i < 100; ++i) {
        radius = distorted / Factor(omega, tangent, radius * radius);
      }
    } else {
      if (distorted * omega >= 1.57) return false;  // beyond 90 degrees
      radius = std::tan(distorted * omega) / tangent;
    }
    const double scale = distorted > 0 ? radius / distorted : 1;
    *ray = {xd * scale, yd * scale, 1};
    return std::isfinite(radius);
  }
};

// Fitzgibbon 2001: ray ~ (x, y, 1 + k (x^2 + y^2)); extra: k.
struct DivisionModel {
  static void Prepare(CameraIntrinsics*) {}

  static bool Project(const CameraIntrinsics& in,
                      double u,
                      double v,
                      double w,
                      double* x,
                      double* y) {
    const double discriminant = w * w - 4 * (u * u + v * v) * in.extra[0];
    const double denominator = w + std::sqrt(discriminant);
    const double scale = 2 / denominator;
    ToPixel(in, scale * u, scale * v, x, y);
    return (discriminant >= 0) & (denominator > 0);
  }
  static bool Unproject(const CameraIntrinsics& in,
                        double x,
                        double y,
                        Eigen::Vector3d* ray) {
    double u, v;
    Normalize(in, x, y, &u, &v);
    const double kr2 = in.extra[0] * (u * u + v * v);
    *ray = {u, v, 1 + kr2};
    // For k > 0 farther pixels belong to the root that Project does not take.
    return kr2 <= 1 && std::isfinite(kr2);
  }
};

// Khomutenko, Garcia, Martinet 2016: extra alpha in [0, 1], beta > 0.
struct EUCMModel {
  static void Prepare(CameraIntrinsics*) {}

  static bool Project(const CameraIntrinsics& in,
                      double u,
                      double v,
                      double w,
                      double* x,
                      double* y) {
    const double alpha = in.extra[0];
    const double beta = in.extra[1];
    const double rho = std::sqrt(beta * (u * u + v * v) + w * w);
    const double denominator = alpha * rho + (1 - alpha) * w;
    ToPixel(in, u / denominator, v / denominator, x, y);
    // The formula is injective for w > -limit * rho (their section II).
    const double limit =
        alpha <= 0.5 ? alpha / (1 - alpha) : (1 - alpha) / alpha;
    return (denominator >= kMinDepth) & (w > -limit * rho);
  }
  static bool Unproject(const CameraIntrinsics& in,
                        double x,
                        double y,
                        Eigen::Vector3d* ray) {
    const double alpha = in.extra[0];
    const double beta = in.extra[1];
    double u, v;
    Normalize(in, x, y, &u, &v);
    const double beta_r2 = beta * (u * u + v * v);
    const double gamma = 1 - alpha;
    const double radicand = 1 - (alpha - gamma) * beta_r2;
    if (!(radicand >= 0)) return false;
    const double denominator = alpha * std::sqrt(radicand) + gamma;
    if (!(denominator >= kMinDepth)) return false;
    *ray = {u, v, (1 - alpha * alpha * beta_r2) / denominator};
    return ray->allFinite();
  }
};

}  // namespace octacut::lens
