// Bilinear samples of photographs at continuous pixel coordinates.
#pragma once

#include <algorithm>
#include <cstdint>
#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

namespace octacut {

// Blue, green, red of a CV_8UC3 image; the centre of the first pixel is
// (0.5, 0.5), outside of the frame its border goes on.
inline Eigen::Vector3f SamplePixels(const cv::Mat& image, double u, double v) {
  const double x = std::clamp(u - 0.5, 0.0, double(image.cols - 1));
  const double y = std::clamp(v - 0.5, 0.0, double(image.rows - 1));
  const int x0 = int(x);
  const int y0 = int(y);
  const size_t right = x0 + 1 < image.cols ? 3 : 0;
  const size_t down = y0 + 1 < image.rows ? image.step[0] : 0;
  const float a = float(x - x0);
  const float b = float(y - y0);
  const uint8_t* top = image.ptr<uint8_t>(y0) + size_t{3} * size_t(x0);
  const uint8_t* bottom = top + down;
  Eigen::Vector3f color;
  for (int c = 0; c < 3; ++c) {
    const float above = float(top[c]) + a * float(top[c + right] - top[c]);
    const float below =
        float(bottom[c]) + a * float(bottom[c + right] - bottom[c]);
    color[c] = above + b * (below - above);
  }
  return color;
}

}  // namespace octacut
