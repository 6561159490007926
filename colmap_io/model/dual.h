// A number with two derivatives, for the Jacobians of lens distortions.
// Private to this folder.
#pragma once

namespace octacut::lens {

struct Dual {
  double value = 0;
  double dx = 0;
  double dy = 0;

  Dual() = default;
  Dual(double constant) : value(constant) {}
  Dual(double v, double x, double y) : value(v), dx(x), dy(y) {}
};

inline Dual operator+(const Dual& a, const Dual& b) {
  return {a.value + b.value, a.dx + b.dx, a.dy + b.dy};
}
inline Dual operator-(const Dual& a, const Dual& b) {
  return {a.value - b.value, a.dx - b.dx, a.dy - b.dy};
}
inline Dual operator*(const Dual& a, const Dual& b) {
  return {a.value * b.value,
          a.dx * b.value + a.value * b.dx,
          a.dy * b.value + a.value * b.dy};
}
inline Dual operator/(const Dual& a, const Dual& b) {
  const double quotient = a.value / b.value;
  return {quotient,
          (a.dx - quotient * b.dx) / b.value,
          (a.dy - quotient * b.dy) / b.value};
}

}  // namespace octacut::lens
