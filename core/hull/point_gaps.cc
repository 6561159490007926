#include "core/hull/point_gaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/base/parallel.h"
#include "core/hull/mask_gaps.h"

namespace octacut {
namespace {

// Points that a disc holds on average, and that prove it to be object: one in
// four is left where the masks of more views are wrong, and a few wrong points
// are hardly ever so close together.
constexpr double kMeanPoints = 12;
constexpr float kMinPoints = 3;
// The largest radius of the disc, in units of the side of a square as large as
// the object: what is narrower than that may be a gap between points.
constexpr double kMaxRadius = 0.06;
// Pixels by which the projection of a sparse point may be wrong.
constexpr double kPointError = 2;

cv::Mat Near(const cv::Mat& marked, double radius) {
  cv::Mat distances;
  cv::distanceTransform(
      ~marked, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  return distances <= radius;
}

// How many points project to each pixel, CV_32FC1.
cv::Mat CountPoints(const View& view,
                    const std::vector<Eigen::Vector3d>& points) {
  cv::Mat counts = cv::Mat::zeros(view.mask.size(), CV_32FC1);
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d in_cam = view.cam_from_world * point;
    if (!(in_cam.z() > 0)) {
      continue;
    }
    const Eigen::Vector2d pixel = view.camera.Project(in_cam);
    if (pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < counts.cols &&
        pixel.y() < counts.rows) {
      counts.at<float>(int(pixel.y()), int(pixel.x())) += 1;
    }
  }
  return counts;
}

cv::Mat Disc(double radius) {
  const int size = 2 * int(radius) + 1;
  cv::Mat center = cv::Mat::zeros(size, size, CV_8UC1);
  center.at<uint8_t>(size / 2, size / 2) = 255;
  return Near(center, radius);
}

// CV_8UC1, 255: background that has to be filled; empty where there is none.
cv::Mat FindGap(const View& view,
                const std::vector<Eigen::Vector3d>& points,
                double mask_tolerance) {
  const cv::Mat object = view.mask >= kObjectThreshold;
  const double area = cv::countNonZero(object);
  cv::Mat counts = CountPoints(view, points);
  cv::Mat of_object = counts.clone();
  of_object.setTo(0, ~object);
  const double density = cv::sum(of_object)[0] / area;
  const double radius =
      std::sqrt(kMeanPoints / (std::numbers::pi * density));  // may be infinite
  if (!(radius <= kMaxRadius * std::sqrt(area))) {
    return {};
  }
  const double depth = std::max(mask_tolerance * view.scale, kPointError);
  counts.setTo(0, Near(object, depth));
  cv::Mat sums;
  cv::filter2D(counts,
               sums,
               CV_32F,
               Disc(radius) / 255,
               cv::Point(-1, -1),
               0,
               cv::BORDER_CONSTANT);
  // Sums of large discs are made in the frequency domain.
  const cv::Mat around = sums > kMinPoints - 0.5f;
  if (cv::countNonZero(around) == 0) {
    return {};
  }
  return (around | (Near(around, depth) & Near(object, depth))) & ~object;
}

}  // namespace

RepairedScene FillGapsAtPoints(const Scene& scene,
                               double mask_tolerance,
                               const Context& context) {
  RepairedScene filled{scene, {}};
  if (scene.points.empty()) {
    return filled;
  }
  std::vector<MaskGap> gaps(scene.views.size());
  ParallelFor(context, gaps.size(), 1, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) {
      const View& view = scene.views[v];
      MaskGap& gap = gaps[v];
      gap.is_gap = FindGap(view, scene.points, mask_tolerance);
      gap.box = cv::Rect(cv::Point(), gap.is_gap.size());
      gap.num_pixels =
          gap.is_gap.empty() ? 0 : size_t(cv::countNonZero(gap.is_gap));
    }
  });
  for (size_t v = 0; v < gaps.size(); ++v) {
    cv::Mat& mask = filled.scene.views[v].mask;
    const double most =
        kMaxGapShare * cv::countNonZero(mask >= kObjectThreshold);
    if (gaps[v].num_pixels > 0 && double(gaps[v].num_pixels) <= most) {
      mask = mask.clone();
      FillGap(gaps[v], &mask);
      filled.gaps.push_back({v, gaps[v].num_pixels});
    }
  }
  if (!filled.gaps.empty()) {
    const FalseGap& largest = LargestGap(filled);
    context.Info(fmt::format(
        "Filled background in {} masks because sparse points of the object lie "
        "there. The most, {} pixels, is filled in the mask of {}.",
        filled.gaps.size(),
        largest.num_pixels,
        scene.views[largest.view].name));
  }
  return filled;
}

}  // namespace octacut
