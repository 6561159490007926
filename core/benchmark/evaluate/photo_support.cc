#include "core/benchmark/evaluate/photo_support.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/base/median.h"
#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kPointGrain = 4096;
// Pixels by which a point may lie behind the depth of its pixel, as in
// reprojection_pair.cc.
constexpr double kBehindPixels = 3;

constexpr double kContradictionSigmas = 3;
constexpr double kLeastContradiction = 0.05;

cv::Mat BoxMean(const cv::Mat& values, int radius) {
  const int side = 2 * radius + 1;
  cv::Mat means;
  cv::boxFilter(values, means, CV_64F, {side, side});
  return means;
}

// 1 at the object's pixels whose whole window is in the frame and not plain.
cv::Mat TexturedPixels(const View& view) {
  if (view.image.empty()) {
    throw InputError(
        fmt::format("photo support: view {} has no image", view.name));
  }
  cv::Mat grey;
  cv::cvtColor(view.image, grey, cv::COLOR_BGR2GRAY);
  grey.convertTo(grey, CV_64F);
  const int radius = ReprojectionOptions::kWindowRadius;
  const cv::Mat mean = BoxMean(grey, radius);
  const cv::Mat variance = BoxMean(grey.mul(grey), radius) - mean.mul(mean);
  cv::Mat textured = (variance > ReprojectionOptions::kMinContrast *
                                     ReprojectionOptions::kMinContrast) &
                     (view.mask >= kObjectThreshold);
  cv::Mat inner = cv::Mat::zeros(textured.size(), CV_8UC1);
  const cv::Rect frame(radius,
                       radius,
                       std::max(0, textured.cols - 2 * radius),
                       std::max(0, textured.rows - 2 * radius));
  if (frame.area() > 0) {
    textured(frame).copyTo(inner(frame));
  }
  return inner;
}

ViewSupport SupportOfView(const cv::Mat& textured, const cv::Mat& map) {
  ViewSupport result;
  double sum = 0;
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      if (textured.at<uint8_t>(y, x) == 0) {
        continue;
      }
      ++result.textured_pixels;
      const float correlation = map.at<float>(y, x);
      if (!std::isnan(correlation)) {
        ++result.compared_pixels;
        sum += correlation;
      }
    }
  }
  if (result.textured_pixels > 0) {
    result.support = sum / double(result.textured_pixels);
  }
  return result;
}

}  // namespace

std::vector<ViewSupport> MeasureViewSupport(const std::vector<View>& views,
                                            const std::vector<cv::Mat>& maps,
                                            const Context& context) {
  std::vector<ViewSupport> support(views.size());
  ParallelEach(context, views.size(), 1, [&](size_t i) {
    support[i] = SupportOfView(TexturedPixels(views[i]), maps[i]);
  });
  return support;
}

double MeanSupport(const std::vector<ViewSupport>& support) {
  double sum = 0;
  int count = 0;
  for (const ViewSupport& view : support) {
    if (view.textured_pixels > 0) {
      sum += view.support;
      ++count;
    }
  }
  return count > 0 ? sum / count : 0;
}

std::vector<bool> ContradictingViews(const std::vector<ViewSupport>& support) {
  std::vector<double> values;
  for (const ViewSupport& view : support) {
    if (view.textured_pixels > 0) {
      values.push_back(view.support);
    }
  }
  std::vector<bool> contradicts(support.size());
  if (values.empty()) {
    return contradicts;
  }
  const MedianSpread usual = SpreadAroundMedian(std::move(values));
  const double limit =
      usual.median -
      std::max(kLeastContradiction, kContradictionSigmas * usual.deviation);
  for (size_t i = 0; i < support.size(); ++i) {
    contradicts[i] =
        support[i].textured_pixels > 0 && support[i].support < limit;
  }
  return contradicts;
}

std::vector<float> SupportOfPoints(const std::vector<Eigen::Vector3d>& points,
                                   const std::vector<View>& views,
                                   const std::vector<cv::Mat>& depths,
                                   const std::vector<cv::Mat>& maps,
                                   const Context& context) {
  std::vector<float> support(points.size());
  Phase phase(context, "support by the photographs", points.size());
  const auto support_of = [&](const Eigen::Vector3d& point) {
    double sum = 0;
    int count = 0;
    for (size_t i = 0; i < views.size(); ++i) {
      const Eigen::Vector3d in_cam = views[i].cam_from_world * point;
      const auto pixel = views[i].camera.ProjectIntoFrame(in_cam);
      if (!pixel) {
        continue;
      }
      const int x = int(pixel->x());
      const int y = int(pixel->y());
      const float depth = depths[i].at<float>(y, x);
      const float value = maps[i].at<float>(y, x);
      const double tolerance = kBehindPixels / views[i].camera.fx;
      if (depth > 0 && in_cam.z() <= depth * (1 + tolerance) &&
          !std::isnan(value)) {
        sum += value;
        ++count;
      }
    }
    return count > 0 ? float(sum / count)
                     : std::numeric_limits<float>::quiet_NaN();
  };
  ParallelFor(
      context, points.size(), kPointGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          support[i] = support_of(points[i]);
        }
        phase.Advance(end - begin);
      });
  return support;
}

}  // namespace octacut
