#include "core/scene/outline_distance.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/scene/pixel_distance.h"

namespace octacut {

OutlineDistance::OutlineDistance(const View& view) {
  const cv::Mat object = view.mask >= kObjectThreshold;
  distances_ = DistancesToZero(~object) - DistancesToZero(object);
  closed_ = !TouchesFrame(cv::boundingRect(object), object.size());
}

double OutlineDistance::At(const Eigen::Vector2d& pixel) const {
  const double width = distances_.cols;
  const double height = distances_.rows;
  const double x = std::clamp(pixel.x(), 0.5, width - 0.5);
  const double y = std::clamp(pixel.y(), 0.5, height - 0.5);
  const double distance = distances_.at<float>(int(y), int(x));
  const double beyond = std::hypot(pixel.x() - x, pixel.y() - y);
  if (closed_) {
    // The frame is convex and holds the object.
    return beyond > 1 ? std::hypot(beyond, distance) : distance;
  }
  return beyond > 1 ? -beyond
                    : std::min({distance, x, y, width - x, height - y});
}

}  // namespace octacut
