// Background with texture, also where the object hides it in most photographs.
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <span>

#include "core/segment/still_background.h"

namespace octacut {

// CV_8UC1, 0 or 255, of a photograph.
struct StillTexture {
  explicit StillTexture(const cv::Size& size)
      : sure(cv::Mat::zeros(size, CV_8U)), near(sure.clone()) {}

  cv::Mat sure;  // background, by its texture
  cv::Mat near;  // what stands still around it
};

// Of the i-th photograph. `labs` are those of a camera that stands still, as
// ToLab makes them, in the order in which the object turned, once around;
// `background` is theirs. A pixel stands still if two of four photographs, one
// and two steps before and after, show the same there; a step is one
// photograph, or as many as it takes for 10 degrees. It is background if there
// is texture around it that has more than one direction and that the most
// frequent colours do not have: the texture of the plate moves, a plain object
// has none, and contours are lines (docs/experiments/mask_turntables.md).
// Nothing is found in fewer than five photographs.
StillTexture FindStillTexture(std::span<const cv::Mat> labs,
                              size_t i,
                              const StillBackground& background);

}  // namespace octacut
