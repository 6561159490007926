// What the object and its surroundings look like: colour models of each view
// and of all views together.
#pragma once

#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/segment/colour_mixture.h"
#include "core/segment/labels.h"

namespace octacut {

class Appearance {
 public:
  // Learns from pixels' features (PixelFeatures) and labels (CV_8UC1), one
  // image of each for every view. A view's own model of the object is used only
  // when `own_objects`; before the object is known, it would be of whatever is
  // in the middle.
  Appearance(std::span<const cv::Mat> features,
             std::span<const cv::Mat> labels,
             bool own_objects,
             const Context& context);

  // CV_32F: log of how much likelier a pixel of the view looks as it does when
  // it is object than when it is not.
  cv::Mat LogOdds(size_t view, const cv::Mat& features) const;

 private:
  struct Models {
    ColourMixture object;
    ColourMixture surroundings;
    bool has_object = false;
    bool has_surroundings = false;
  };
  Models pooled_;
  std::vector<Models> own_;
};

}  // namespace octacut
