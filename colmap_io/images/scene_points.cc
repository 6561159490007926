#include "colmap_io/images/scene_points.h"

#include <algorithm>
#include <limits>

#include "core/scene/region.h"

namespace octacut {
namespace {

constexpr double kMaxErrorOverMedian = 4;
constexpr size_t kMinTrack = 3;

double ErrorLimit(const std::vector<SparsePoint>& points) {
  std::vector<double> errors;
  for (const SparsePoint& point : points) {
    if (point.error > 0) {
      errors.push_back(point.error);
    }
  }
  if (errors.empty()) {
    return std::numeric_limits<double>::infinity();
  }
  const auto middle = errors.begin() + std::ptrdiff_t(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return kMaxErrorOverMedian * *middle;
}

}  // namespace

std::vector<Eigen::Vector3d> ScenePoints(const std::vector<SparsePoint>& points,
                                         const std::vector<View>& views) {
  const double error_limit = ErrorLimit(points);
  size_t longest = 0;
  for (const SparsePoint& point : points) {
    longest = std::max(longest, point.track.size());
  }
  const size_t min_track = std::min(kMinTrack, longest);
  std::vector<Eigen::Vector3d> positions;
  for (const SparsePoint& point : points) {
    if (!(point.error > error_limit) && point.track.size() >= min_track &&
        point.xyz.allFinite()) {
      positions.push_back(point.xyz);
    }
  }
  std::vector<Eigen::Vector3d> inside;
  for (size_t i : PointsInsideMasks(views, positions)) {
    inside.push_back(positions[i]);
  }
  return inside;
}

}  // namespace octacut
