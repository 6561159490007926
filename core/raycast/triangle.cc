#include "core/raycast/triangle.h"

#include <algorithm>
#include <Eigen/Geometry>

namespace octacut {
namespace {

Eigen::Vector3d ClosestPointOnSegment(const Eigen::Vector3d& query,
                                      const Eigen::Vector3d& a,
                                      const Eigen::Vector3d& b) {
  const Eigen::Vector3d ab = b - a;
  const double length_squared = ab.squaredNorm();
  if (length_squared == 0) {
    return a;
  }
  return a + std::clamp(ab.dot(query - a) / length_squared, 0.0, 1.0) * ab;
}

}  // namespace

Eigen::Vector3d ClosestPointOnTriangle(const Eigen::Vector3d& query,
                                       const Eigen::Vector3d& a,
                                       const Eigen::Vector3d& b,
                                       const Eigen::Vector3d& c) {
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double normal_squared = normal.squaredNorm();
  // Twice the signed areas over the edges, as fractions of |normal|.
  const double over_ab = (b - a).cross(query - a).dot(normal);
  const double over_bc = (c - b).cross(query - b).dot(normal);
  const double over_ca = (a - c).cross(query - c).dot(normal);
  if (normal_squared > 0 && over_ab >= 0 && over_bc >= 0 && over_ca >= 0) {
    return query - (normal.dot(query - a) / normal_squared) * normal;
  }
  Eigen::Vector3d best = ClosestPointOnSegment(query, a, b);
  for (const Eigen::Vector3d& point : {ClosestPointOnSegment(query, b, c),
                                       ClosestPointOnSegment(query, c, a)}) {
    if ((point - query).squaredNorm() < (best - query).squaredNorm()) {
      best = point;
    }
  }
  return best;
}

}  // namespace octacut
