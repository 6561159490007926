#include "core/scene/pixel_distance.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace octacut {

cv::Mat DistancesToZero(const cv::Mat& image) {
  cv::Mat distances;
  cv::distanceTransform(
      image, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  return distances;
}

cv::Mat PixelsNear(const cv::Mat& marked, double radius) {
  return DistancesToZero(~marked) <= radius;
}

bool TouchesFrame(const cv::Rect& box, const cv::Size& frame) {
  return box.x == 0 || box.y == 0 || box.br().x == frame.width ||
         box.br().y == frame.height;
}

}  // namespace octacut
