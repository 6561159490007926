// Pixels that were filled in an image's reduced mask, for its full one.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/scene/camera.h"

namespace octacut {

class FilledBites {
 public:
  // `pixels` CV_8UC1 of the size of `camera`, 255 = filled; always the same
  // camera.
  void Add(const PinholeCamera& camera, const cv::Mat& pixels);

  // Makes object of those of the pixels of a mask of the same pose and the
  // given camera that lie in filled ones.
  void Fill(const PinholeCamera& camera, cv::Mat* mask) const;

 private:
  PinholeCamera camera_;
  cv::Mat pixels_;  // empty: none
};

}  // namespace octacut
