#include "core/benchmark/synthetic/move_mask_border.h"

#include <cstdlib>
#include <opencv2/imgproc.hpp>

namespace octacut {
namespace {

cv::Mat Disc(int radius) {
  cv::Mat disc = cv::Mat::zeros(2 * radius + 1, 2 * radius + 1, CV_8UC1);
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) {
      disc.at<uint8_t>(y + radius, x + radius) =
          x * x + y * y <= radius * radius;
    }
  }
  return disc;
}

}  // namespace

cv::Mat MoveMaskBorder(const cv::Mat& mask, int pixels) {
  if (pixels == 0) {
    return mask;
  }
  // The default border of both never wins, so the frame changes nothing.
  cv::Mat moved;
  if (pixels > 0) {
    cv::dilate(mask, moved, Disc(pixels));
  } else {
    cv::erode(mask, moved, Disc(-pixels));
  }
  return moved;
}

}  // namespace octacut
