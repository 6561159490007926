#include "core/hull/point_gaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/hull/mask_gaps.h"
#include "core/scene/pixel_distance.h"

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

// How many points project to each pixel, CV_32FC1.
cv::Mat CountPoints(const View& view,
                    const std::vector<Eigen::Vector3d>& points) {
  cv::Mat counts = cv::Mat::zeros(view.mask.size(), CV_32FC1);
  for (const Eigen::Vector3d& point : points) {
    const auto pixel =
        view.camera.ProjectIntoFrame(view.cam_from_world * point);
    if (pixel) {
      counts.at<float>(int(pixel->y()), int(pixel->x())) += 1;
    }
  }
  return counts;
}

cv::Mat Disc(double radius) {
  const int size = 2 * int(radius) + 1;
  cv::Mat center = cv::Mat::zeros(size, size, CV_8UC1);
  center.at<uint8_t>(size / 2, size / 2) = 255;
  return PixelsNear(center, radius);
}

// CV_8UC1, 255: background that has to be filled; empty where there is none.
cv::Mat FindGap(const View& view,
                const std::vector<Eigen::Vector3d>& points,
                double mask_tolerance) {
  const cv::Mat object = view.mask >= kObjectThreshold;
  cv::Mat counts = CountPoints(view, points);
  const double density = cv::mean(counts, object)[0];
  const double radius =
      std::sqrt(kMeanPoints / (std::numbers::pi * density));  // may be infinite
  if (radius > kMaxRadius * std::sqrt(double(cv::countNonZero(object)))) {
    return {};
  }
  const double depth = std::max(mask_tolerance * view.scale, kPointError);
  const cv::Mat near_object = PixelsNear(object, depth);
  counts.setTo(0, near_object);
  cv::Mat sums;
  cv::filter2D(counts,
               sums,
               CV_32F,
               Disc(radius) / 255,
               cv::Point(-1, -1),
               0,
               cv::BORDER_CONSTANT);
  // OpenCV sums large discs by Fourier transforms, so that sums are not quite
  // whole numbers.
  const cv::Mat around = sums > kMinPoints - 0.5f;
  if (cv::countNonZero(around) == 0) {
    return {};
  }
  // With the strip between it and the object. At a straight border of the
  // object this reaches 0.4 radii too far, which other masks carve away again;
  // what is not filled, they cannot give back.
  return (around | (PixelsNear(around, depth) & near_object)) & ~object;
}

struct FilledView {
  std::vector<size_t> gap_pixels;  // of each gap that is filled
  bool is_too_large = false;       // what would have to be filled
};

FilledView FillView(const std::vector<Eigen::Vector3d>& points,
                    double mask_tolerance,
                    View* view) {
  FilledView filled;
  MaskGap gap;
  gap.is_gap = FindGap(*view, points, mask_tolerance);
  if (gap.is_gap.empty()) {
    return filled;
  }
  const double most =
      kMaxGapShare * cv::countNonZero(view->mask >= kObjectThreshold);
  filled.is_too_large = cv::countNonZero(gap.is_gap) > most;
  if (filled.is_too_large) {
    return filled;
  }
  cv::Mat labels;
  cv::Mat statistics;
  cv::Mat centers;
  const int num_labels =
      cv::connectedComponentsWithStats(gap.is_gap, labels, statistics, centers);
  for (int i = 1; i < num_labels; ++i) {
    filled.gap_pixels.push_back(
        size_t(statistics.at<int>(i, cv::CC_STAT_AREA)));
  }
  gap.box = cv::Rect(cv::Point(), gap.is_gap.size());
  view->mask = view->mask.clone();
  FillGap(gap, &view->mask);
  return filled;
}

}  // namespace

RepairedScene FillGapsAtPoints(const Scene& scene,
                               double mask_tolerance,
                               const Context& context) {
  RepairedScene filled{scene, {}};
  if (scene.points.empty()) {
    return filled;
  }
  std::vector<FilledView> of_views(scene.views.size());
  ParallelEach(context, of_views.size(), 1, [&](size_t v) {
    of_views[v] =
        FillView(scene.points, mask_tolerance, &filled.scene.views[v]);
  });
  std::vector<std::string> too_large;
  for (size_t v = 0; v < of_views.size(); ++v) {
    for (const size_t num_pixels : of_views[v].gap_pixels) {
      filled.gaps.push_back({v, num_pixels});
    }
    if (of_views[v].is_too_large) {
      too_large.push_back(scene.views[v].name);
    }
  }
  ReportGaps(filled, "sparse points of the object lie", context);
  if (!too_large.empty()) {
    context.Info(fmt::format(
        "Sparse points of the object lie in background that is larger than a "
        "twentieth of the object. The masks of these images are left as they "
        "are: {}.",
        fmt::join(too_large, ", ")));
  }
  return filled;
}

}  // namespace octacut
