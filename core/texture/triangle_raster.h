// Pixels of triangles in a plane.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Core>

namespace octacut {

// Weights of the corners for a point of the triangle's plane; outside of the
// triangle some are negative. NaN for triangles without area.
inline Eigen::Vector3d CornerWeights(
    const std::array<Eigen::Vector2d, 3>& triangle,
    const Eigen::Vector2d& point) {
  const Eigen::Vector2d b = triangle[1] - triangle[0];
  const Eigen::Vector2d c = triangle[2] - triangle[0];
  const Eigen::Vector2d p = point - triangle[0];
  const double area = b.x() * c.y() - b.y() * c.x();
  const double u = (p.x() * c.y() - p.y() * c.x()) / area;
  const double v = (b.x() * p.y() - b.y() * p.x()) / area;
  return {1 - u - v, u, v};
}

// The same, but those of the first corner for triangles without area, and for
// slivers where the point lies far beyond their corners.
inline Eigen::Vector3d BoundedCornerWeights(
    const std::array<Eigen::Vector2d, 3>& triangle,
    const Eigen::Vector2d& point) {
  constexpr double kLargestWeight = 16;
  const Eigen::Vector3d weights = CornerWeights(triangle, point);
  return weights.allFinite() && weights.cwiseAbs().maxCoeff() < kLargestWeight
             ? weights
             : Eigen::Vector3d(1, 0, 0);
}

// Calls body(x, y) for the pixels of a width x height image whose centres
// (x + 0.5, y + 0.5) the triangle contains. Of triangles that share an edge one
// alone has a centre on it (the rule of rasterisers: top and left edges).
template <typename Body>
void ForPixelsInside(const std::array<Eigen::Vector2d, 3>& triangle,
                     int width,
                     int height,
                     const Body& body) {
  std::array<Eigen::Vector2d, 3> t = triangle;
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  const double area = cross(t[1] - t[0], t[2] - t[0]);
  if (!(area != 0)) {
    return;
  }
  if (area < 0) {
    std::swap(t[1], t[2]);
  }
  const Eigen::Vector2d low = t[0].cwiseMin(t[1]).cwiseMin(t[2]);
  const Eigen::Vector2d high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
  const int x0 = std::max(0, int(std::ceil(low.x() - 0.5)));
  const int y0 = std::max(0, int(std::ceil(low.y() - 0.5)));
  const int x1 = std::min(width - 1, int(std::floor(high.x() - 0.5)));
  const int y1 = std::min(height - 1, int(std::floor(high.y() - 0.5)));
  // From the end that comes first, so that both triangles of an edge compute
  // the same figure.
  const auto side = [&](int k, const Eigen::Vector2d& p) {
    const Eigen::Vector2d& a = t[size_t(k)];
    const Eigen::Vector2d& b = t[size_t(k + 1) % 3];
    const bool swapped = b.x() < a.x() || (b.x() == a.x() && b.y() < a.y());
    const double value = swapped ? -cross(a - b, p - b) : cross(b - a, p - a);
    if (value != 0) {
      return value;
    }
    const Eigen::Vector2d d = b - a;
    return d.y() < 0 || (d.y() == 0 && d.x() > 0) ? 1.0 : -1.0;
  };
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const Eigen::Vector2d p(x + 0.5, y + 0.5);
      if (side(0, p) > 0 && side(1, p) > 0 && side(2, p) > 0) {
        body(x, y);
      }
    }
  }
}

// Squared distance of a point to a triangle that it is not in.
inline double SquaredDistanceToEdges(
    const std::array<Eigen::Vector2d, 3>& triangle, const Eigen::Vector2d& p) {
  double best = std::numeric_limits<double>::infinity();
  for (size_t k = 0; k < 3; ++k) {
    const Eigen::Vector2d& a = triangle[k];
    const Eigen::Vector2d d = triangle[(k + 1) % 3] - a;
    const double length = d.squaredNorm();
    const double t =
        length > 0 ? std::clamp((p - a).dot(d) / length, 0.0, 1.0) : 0.0;
    best = std::min(best, (a + t * d - p).squaredNorm());
  }
  return best;
}

}  // namespace octacut
