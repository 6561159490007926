#include "colmap_io/images/filled_bites.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace octacut {

void FilledBites::Add(const PinholeCamera& camera, const cv::Mat& pixels) {
  camera_ = camera;
  pixels_ = pixels_.empty() ? pixels.clone() : cv::Mat(pixels_ | pixels);
}

void FilledBites::Fill(const PinholeCamera& camera, cv::Mat* mask) const {
  if (pixels_.empty()) {
    return;
  }
  for (int y = 0; y < mask->rows; ++y) {
    uint8_t* row = mask->ptr<uint8_t>(y);
    for (int x = 0; x < mask->cols; ++x) {
      const Eigen::Vector2d pixel =
          camera_.Project(camera.Unproject({x + 0.5, y + 0.5}));
      if (pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < pixels_.cols &&
          pixel.y() < pixels_.rows &&
          pixels_.at<uint8_t>(int(pixel.y()), int(pixel.x())) != 0) {
        row[x] = 255;
      }
    }
  }
}

}  // namespace octacut
