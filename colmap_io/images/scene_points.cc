#include "colmap_io/images/scene_points.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/base/median.h"
#include "core/scene/region.h"

namespace octacut {
namespace {

constexpr double kMaxErrorOverMedian = 4;
constexpr size_t kMinTrack = 3;
// Views share shadows, in which masks miss the object.
constexpr double kMinShareOfViews = 0.8;

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
  return kMaxErrorOverMedian * Median(std::move(errors));
}

// The view of each image id.
std::unordered_map<uint32_t, const View*> ViewsByImage(
    const SparseModel& model, const std::vector<View>& views) {
  std::unordered_map<std::string_view, const View*> by_name;
  for (const View& view : views) {
    by_name[view.name] = &view;
  }
  std::unordered_map<uint32_t, const View*> by_image;
  for (const SparseImage& image : model.images) {
    const auto found = by_name.find(image.name);
    if (found != by_name.end()) {
      by_image[image.id] = found->second;
    }
  }
  return by_image;
}

bool IsInsideMask(const Eigen::Vector3d& point, const View& view) {
  const auto pixel = view.camera.ProjectIntoFrame(view.cam_from_world * point);
  return pixel && view.mask.at<uint8_t>(int(pixel->y()), int(pixel->x())) >=
                      kObjectThreshold;
}

}  // namespace

std::vector<Eigen::Vector3d> ScenePoints(const SparseModel& model,
                                         const std::vector<View>& views) {
  const double error_limit = ErrorLimit(model.points);
  const auto by_image = ViewsByImage(model, views);
  size_t longest = 0;
  for (const SparsePoint& point : model.points) {
    longest = std::max(longest, point.track.size());
  }
  const size_t min_track = std::min(kMinTrack, longest);
  std::vector<Eigen::Vector3d> positions;
  for (const SparsePoint& point : model.points) {
    if (point.error > error_limit || point.track.size() < min_track ||
        !point.xyz.allFinite()) {
      continue;
    }
    size_t inside = 0;
    size_t outside = 0;
    for (const TrackElement& element : point.track) {
      const auto view = by_image.find(element.image_id);
      if (view != by_image.end()) {
        ++(IsInsideMask(point.xyz, *view->second) ? inside : outside);
      }
    }
    if (inside >= 2 && inside >= 4 * outside) {
      positions.push_back(point.xyz);
    }
  }
  std::vector<Eigen::Vector3d> result;
  for (size_t i : PointsInsideMasks(views, positions, kMinShareOfViews)) {
    result.push_back(positions[i]);
  }
  return result;
}

}  // namespace octacut
