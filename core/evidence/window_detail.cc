#include "core/evidence/window_detail.h"

#include <opencv2/imgproc.hpp>

namespace octacut {
namespace {

// Half the side, in window radii, of the square whose windows are counted.
constexpr int kRadiiAround = 2;

// Sums over the windows of what the samples are multiplied by, row and column.
cv::Mat1f WeightedSums(const cv::Mat1f& grey,
                       const cv::Mat1f& across,
                       const cv::Mat1f& down) {
  cv::Mat1f sums;
  cv::sepFilter2D(grey, sums, CV_32F, across, down);
  return sums;
}

}  // namespace

cv::Mat1f ShareWithDetail(const cv::Mat1f& grey,
                          int window_radius,
                          float deviation) {
  const int width = 2 * window_radius + 1;
  const cv::Mat1f ones(1, width, 1.0f);
  cv::Mat1f steps(1, width);
  float squares = 0;  // of the steps of all samples of a window
  for (int i = 0; i < width; ++i) {
    steps(i) = float(i - window_radius);
    squares += float(width) * steps(i) * steps(i);
  }
  const auto count = float(width * width);
  // The variance less that of the plane.
  const cv::Mat1f sum = WeightedSums(grey, ones, ones);
  const cv::Mat1f slope_x = WeightedSums(grey, steps, ones);
  const cv::Mat1f slope_y = WeightedSums(grey, ones, steps);
  const cv::Mat1f variance =
      (WeightedSums(grey.mul(grey), ones, ones) - sum.mul(sum) / count -
       (slope_x.mul(slope_x) + slope_y.mul(slope_y)) / squares) /
      count;
  const int side = 2 * kRadiiAround * window_radius + 1;
  cv::Mat1f share;
  cv::boxFilter(variance >= deviation * deviation, share, CV_32F, {side, side});
  return share / 255;  // comparisons give 0 and 255
}

}  // namespace octacut
