// How far from the object of a view a point projects.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "core/scene/scene.h"

namespace octacut {

class OutlineDistance {
 public:
  // Keeps neither image nor mask.
  explicit OutlineDistance(const View& view);

  // Pixels from `pixel` to the object, or minus those to the background. A
  // lower bound beyond the frame of a view whose object is clear of it. Beyond
  // the frame of other views nothing is known: minus the pixels to the frame
  // there, and nowhere more than those.
  double At(const Eigen::Vector2d& pixel) const;

 private:
  cv::Mat distances_;  // CV_32F
  bool closed_ = false;
};

}  // namespace octacut
