// Directions of rays: patterns of a disc and frames around an axis.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <numbers>
#include <vector>

#include "core/base/hash.h"

namespace octacut {

// Points that fill the unit disc evenly, any first few of them too (the
// additive recurrence of the plastic number's powers in the unit square,
// wrapped onto the disc). Turned about the centre, one pattern serves many
// places without leaving its trace in a picture.
class DiscPattern {
 public:
  explicit DiscPattern(int count) {
    for (int i = 0; i < count; ++i) {
      const double u = std::fmod(0.5 + 0.7548776662466927 * i, 1.0);
      const double v = std::fmod(0.5 + 0.5698402909980532 * i, 1.0);
      points_.push_back(Eigen::Rotation2Dd(2 * std::numbers::pi * u) *
                        Eigen::Vector2d(std::sqrt(v), 0));
    }
  }
  // The turn that belongs to `bits`.
  static Eigen::Matrix2d Turn(uint64_t bits) {
    return Eigen::Rotation2Dd(2 * std::numbers::pi *
                              HashUniform(HashBits(bits)))
        .toRotationMatrix();
  }
  const Eigen::Vector2d& operator[](int index) const {
    return points_[static_cast<size_t>(index)];
  }

 private:
  std::vector<Eigen::Vector2d> points_;
};

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
