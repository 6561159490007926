#include "core/benchmark/evaluate/mean_colors.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <optional>
#include <utility>

#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kColorGrain = 1024;
constexpr size_t kMostViews = 3;
constexpr std::array<uint8_t, 3> kUnseen = {128, 128, 128};
// Views at more than 80 degrees to the normal say little of the colour.
constexpr double kLeastCosine = 0.17;
// The share of the distance to the camera by which a ray may end before its
// point: the point of a simplified mesh lies up to a few pixels below the full
// one.
constexpr double kClearance = 5e-3;

std::optional<cv::Vec3d> ColorAt(const View& view,
                                 const Eigen::Vector3d& point) {
  const Eigen::Vector3d in_cam = view.cam_from_world * point;
  if (!(in_cam.z() > 0)) {
    return std::nullopt;
  }
  const Eigen::Vector2d pixel = view.camera.Project(in_cam);
  const double x = pixel.x() - 0.5;
  const double y = pixel.y() - 0.5;
  if (!(x >= 0 && y >= 0 && x < view.image.cols - 1 &&
        y < view.image.rows - 1)) {
    return std::nullopt;
  }
  const int u = int(x);
  const int v = int(y);
  const auto value = [&](int dx, int dy) {
    return cv::Vec3d(view.image.at<cv::Vec3b>(v + dy, u + dx));
  };
  const cv::Vec3d top = value(0, 0) * (u + 1 - x) + value(1, 0) * (x - u);
  const cv::Vec3d bottom = value(0, 1) * (u + 1 - x) + value(1, 1) * (x - u);
  return top * (v + 1 - y) + bottom * (y - v);
}

std::array<uint8_t, 3> MeanColorOf(
    const Eigen::Vector3d& point,
    const Eigen::Vector3d& normal,
    const RayScene& rays,
    const std::vector<View>& views,
    const std::vector<Eigen::Vector3d>& centers) {
  std::vector<std::pair<double, size_t>> candidates;
  for (size_t i = 0; i < views.size(); ++i) {
    const double cosine = normal.dot((centers[i] - point).normalized());
    if (cosine > kLeastCosine) {
      candidates.emplace_back(-cosine, i);
    }
  }
  std::sort(candidates.begin(), candidates.end());
  cv::Vec3d sum(0, 0, 0);
  size_t count = 0;
  for (const auto& [minus_cosine, i] : candidates) {
    const auto color = ColorAt(views[i], point);
    if (color &&
        !rays.IsOccluded(centers[i], point - centers[i], 0, 1 - kClearance)) {
      sum += *color;
      if (++count == kMostViews) {
        break;
      }
    }
  }
  if (count == 0) {
    return kUnseen;
  }
  std::array<uint8_t, 3> mean;
  for (int channel = 0; channel < 3; ++channel) {
    mean[size_t(channel)] = cv::saturate_cast<uint8_t>(
        std::lround(sum[2 - channel] / double(count)));
  }
  return mean;
}

}  // namespace

std::vector<std::array<uint8_t, 3>> MeanColors(
    const std::vector<Eigen::Vector3d>& points,
    const std::vector<Eigen::Vector3f>& normals,
    const RayScene& rays,
    const std::vector<View>& views,
    const Context& context) {
  std::vector<Eigen::Vector3d> centers;
  for (const View& view : views) {
    centers.push_back(view.Center());
  }
  std::vector<std::array<uint8_t, 3>> colors(points.size());
  Phase phase(context, "colours from the photographs", points.size());
  ParallelFor(
      context, points.size(), kColorGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          colors[i] = MeanColorOf(
              points[i], normals[i].cast<double>(), rays, views, centers);
        }
        phase.Advance(end - begin);
      });
  return colors;
}

}  // namespace octacut
