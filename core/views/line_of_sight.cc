#include "core/views/line_of_sight.h"

namespace octacut {

std::vector<Eigen::Vector3f> PointsOnLine(const Eigen::Vector3f& center,
                                          const Eigen::Vector3f& direction,
                                          int points_per_edge) {
  const float middle = direction.dot(Eigen::Vector3f::Constant(0.5f) - center);
  // Half the cube's diagonal is 0.866.
  const int reach = points_per_edge * 7 / 8;
  std::vector<Eigen::Vector3f> points;
  points.reserve(size_t(2 * reach) + 1);
  for (int i = -reach; i <= reach; ++i) {
    const float depth = middle + float(i) / float(points_per_edge);
    const Eigen::Vector3f point = center + depth * direction;
    if (depth > 0 && point.minCoeff() >= 0 && point.maxCoeff() <= 1) {
      points.push_back(point);
    }
  }
  return points;
}

}  // namespace octacut
