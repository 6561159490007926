// Whether a pixel has the colours of an object or those of its surroundings.
#pragma once

#include <opencv2/core/mat.hpp>
#include <span>

#include "core/segment/colour_mixture.h"
#include "core/segment/pixel_features.h"

namespace octacut {

class ColourContrast {
 public:
  // The largest log odds, of either sign.
  static constexpr float kMostOdds = 4;

  // Learns from samples of both.
  ColourContrast(std::span<const PixelFeature> object,
                 std::span<const PixelFeature> surroundings);

  // CV_32F: log odds of object against surroundings by the features
  // (PixelFeatures) of the pixels that are set in `chosen` (CV_8UC1); 0
  // elsewhere.
  cv::Mat LogOdds(const cv::Mat& features, const cv::Mat& chosen) const;

 private:
  ColourMixture object_;
  ColourMixture surroundings_;
};

}  // namespace octacut
