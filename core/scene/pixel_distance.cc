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

}  // namespace octacut
