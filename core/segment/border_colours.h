// What is object and what is not beside a border, by colours.
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "core/segment/colour_mixture.h"

namespace octacut {

// Colours to either side of a border: of all of it, and of its part near each
// of the tiles that the picture is divided into, since what is next to the
// border here need not be so elsewhere. Colours of the surroundings are also
// learned as they are in shadow.
class BorderColours {
 public:
  // Learns from pixels that are farther than `reach` from the border and near
  // it. `features` are those of PixelFeatures; `inside` and `outside` (CV_32F)
  // are the distances of pixels from the border, 0 on its other side.
  BorderColours(const cv::Mat& features,
                const cv::Mat& inside,
                const cv::Mat& outside,
                double reach);

  // Log odds of the object for the features of a pixel.
  float LogOdds(int y, int x, const PixelFeature& feature) const;

  // Reaches from the border up to which colours are learned.
  static constexpr double kLearnReaches = 5;

 private:
  struct Colours {
    ColourMixture object;
    ColourMixture surroundings;
  };

  Colours whole_;
  int tile_side_;
  int num_columns_;
  std::vector<std::optional<Colours>> tiles_;  // none: too few pixels are near
};

}  // namespace octacut
