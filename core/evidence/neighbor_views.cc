#include "core/evidence/neighbor_views.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace octacut {

std::vector<std::vector<int>> SelectNeighborViews(const ViewSet& views,
                                                  int count,
                                                  double min_angle,
                                                  double max_angle) {
  constexpr double kBestAngle = 15;
  const Eigen::Vector3f target = Eigen::Vector3f::Constant(0.5f);
  std::vector<std::vector<int>> neighbors(views.size());
  for (size_t i = 0; i < views.size(); ++i) {
    const Eigen::Vector3f own =
        (views[i].projection.center - target).normalized();
    std::vector<std::pair<double, int>> candidates;
    for (size_t j = 0; j < views.size(); ++j) {
      const Eigen::Vector3f other =
          (views[j].projection.center - target).normalized();
      const double cosine = std::clamp(double(own.dot(other)), -1.0, 1.0);
      const double angle = std::acos(cosine) * 180 / std::numbers::pi;
      if (j != i && angle >= min_angle && angle <= max_angle) {
        candidates.emplace_back(std::abs(angle - kBestAngle), int(j));
      }
    }
    std::sort(candidates.begin(), candidates.end());
    for (size_t k = 0; k < candidates.size() && int(k) < count; ++k) {
      neighbors[i].push_back(candidates[k].second);
    }
  }
  return neighbors;
}

}  // namespace octacut
