// Distortions of COLMAP's camera models as functions of the undistorted
// coordinates (u, v): normalized coordinates for perspective models, direction
// times angle off the axis for fisheyes. `k` points at the model's distortion
// parameters in COLMAP's order. Scalars are double or Dual (derivatives).
//
// Each has RadialFactor(k, s): the factor of its radially symmetric part at
// squared radius s; kIsRadial says that there is no other part.
//
// Private to this folder.
#pragma once

#include "colmap_io/model/dual.h"

namespace octacut::lens {

// OpenCV's tangential part added to (x, y); in COLMAP's words p1, p2.
template <typename T>
void AddTangential(double p1, double p2, const T& u, const T& v, T* x, T* y) {
  const T s = u * u + v * v;
  const T uv = u * v;
  *x = *x + 2.0 * p1 * uv + p2 * (s + 2.0 * (u * u));
  *y = *y + 2.0 * p2 * uv + p1 * (s + 2.0 * (v * v));
}

struct NoDistortion {
  static constexpr bool kIsRadial = true;
  template <typename T>
  static T RadialFactor(const double*, const T&) {
    return T(1.0);
  }
  template <typename T>
  static void Apply(const double*, const T& u, const T& v, T* x, T* y) {
    *x = u;
    *y = v;
  }
};

// 1 + k[0] s + k[1] s^2 + ... + k[N-1] s^N.
template <int N>
struct RadialPolynomial {
  static constexpr bool kIsRadial = true;
  template <typename T>
  static T RadialFactor(const double* k, const T& s) {
    T sum = T(k[N - 1]);
    for (int i = N - 2; i >= 0; --i) sum = sum * s + T(k[i]);
    return sum * s + T(1.0);
  }
  template <typename T>
  static void Apply(const double* k, const T& u, const T& v, T* x, T* y) {
    const T factor = RadialFactor(k, T(u * u + v * v));
    *x = u * factor;
    *y = v * factor;
  }
};

// k1 k2 p1 p2.
struct OpenCVDistortion {
  static constexpr bool kIsRadial = false;
  template <typename T>
  static T RadialFactor(const double* k, const T& s) {
    return RadialPolynomial<2>::RadialFactor(k, s);
  }
  template <typename T>
  static void Apply(const double* k, const T& u, const T& v, T* x, T* y) {
    RadialPolynomial<2>::Apply(k, u, v, x, y);
    AddTangential(k[2], k[3], u, v, x, y);
  }
};

// k1 k2 p1 p2 k3 k4 k5 k6: rational radial part.
struct FullOpenCVDistortion {
  static constexpr bool kIsRadial = false;
  template <typename T>
  static T RadialFactor(const double* k, const T& s) {
    const T numerator = ((k[4] * s + T(k[1])) * s + T(k[0])) * s + T(1.0);
    const T denominator = ((k[7] * s + T(k[6])) * s + T(k[5])) * s + T(1.0);
    return numerator / denominator;
  }
  template <typename T>
  static void Apply(const double* k, const T& u, const T& v, T* x, T* y) {
    const T factor = RadialFactor(k, T(u * u + v * v));
    *x = u * factor;
    *y = v * factor;
    AddTangential(k[2], k[3], u, v, x, y);
  }
};

// k1 k2 p1 p2 k3 k4 sx1 sy1.
struct ThinPrismDistortion {
  static constexpr bool kIsRadial = false;
  template <typename T>
  static T RadialFactor(const double* k, const T& s) {
    const T high = (k[5] * s + T(k[4])) * s;
    return ((high + T(k[1])) * s + T(k[0])) * s + T(1.0);
  }
  template <typename T>
  static void Apply(const double* k, const T& u, const T& v, T* x, T* y) {
    const T s = u * u + v * v;
    const T factor = RadialFactor(k, s);
    *x = u * factor + k[6] * s;
    *y = v * factor + k[7] * s;
    AddTangential(k[2], k[3], u, v, x, y);
  }
};

// k0..k5 p0 p1 s0..s3: the tangential and thin prism parts act on the radially
// distorted coordinates, and p0 and p1 change places against OpenCV's p1, p2.
struct RadTanThinPrismDistortion {
  static constexpr bool kIsRadial = false;
  template <typename T>
  static T RadialFactor(const double* k, const T& s) {
    return RadialPolynomial<6>::RadialFactor(k, s);
  }
  template <typename T>
  static void Apply(const double* k, const T& u, const T& v, T* x, T* y) {
    T radial_x, radial_y;
    RadialPolynomial<6>::Apply(k, u, v, &radial_x, &radial_y);
    const T s = radial_x * radial_x + radial_y * radial_y;
    *x = radial_x + (k[8] + k[9] * s) * s;
    *y = radial_y + (k[10] + k[11] * s) * s;
    AddTangential(k[7], k[6], radial_x, radial_y, x, y);
  }
};

}  // namespace octacut::lens
