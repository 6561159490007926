// Random numbers for rays that any thread may draw in any order: hashes
// instead of a generator with a state.
#pragma once

#include <cmath>
#include <cstdint>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <numbers>

namespace octacut {

// A well mixed 64-bit hash (the finalizer of splitmix64) of a chain of
// numbers.
inline uint64_t HashBits(uint64_t value) {
  value += 0x9e3779b97f4a7c15u;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}
template <typename... Rest>
uint64_t HashBits(uint64_t first, uint64_t second, Rest... rest) {
  return HashBits(HashBits(first) ^ second, rest...);
}

// Uniform in [0, 1).
inline double HashUniform(uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

// Point `index` of a sequence that fills the unit disc evenly; every `bits`
// gives another such sequence. (The additive recurrence of the plastic
// number's powers in the unit square, shifted, wrapped onto the disc.)
inline Eigen::Vector2d DiscSample(int index, uint64_t bits) {
  const double u = std::fmod(
      HashUniform(HashBits(bits, 1)) + 0.7548776662466927 * index, 1.0);
  const double v = std::fmod(
      HashUniform(HashBits(bits, 2)) + 0.5698402909980532 * index, 1.0);
  const double angle = 2 * std::numbers::pi * u;
  return std::sqrt(v) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

// An orthonormal frame around a unit vector.
struct AxisFrame {
  explicit AxisFrame(const Eigen::Vector3d& axis)
      : z(axis), x(axis.unitOrthogonal()), y(z.cross(x)) {}

  // Cosine-weighted direction of the hemisphere over `z`: a point of the
  // disc, lifted.
  Eigen::Vector3d Hemisphere(const Eigen::Vector2d& disc) const {
    const double height = std::sqrt(std::max(0.0, 1 - disc.squaredNorm()));
    return disc.x() * x + disc.y() * y + height * z;
  }
  // Direction toward a point of a disc that faces the origin at distance 1.
  Eigen::Vector3d Disc(const Eigen::Vector2d& disc) const {
    return z + disc.x() * x + disc.y() * y;
  }

  Eigen::Vector3d z, x, y;
};

}  // namespace octacut
