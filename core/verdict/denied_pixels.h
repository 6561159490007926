// Pixels of a mask's object on whose rays the other masks leave nothing: no
// object can fill all masks then, and some mask is too small.
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/views/view_set.h"

namespace octacut {

struct DeniedPixels {
  size_t count = 0;  // of the view's pixels, from a sample of them
  // One per view: pixels that it denies alone or with one other, so that its
  // mask is likely to be wrong.
  std::vector<size_t> by_view;
};

// The denied pixels among those of `views[view]` that are not 0 in `pixels`
// (CV_8UC1). A view denies a point that it shows more than `margins` (pixels,
// one per view) outside of the border of its object. A pixel is denied if every
// point of its ray within the root cube is denied; by_view counts the views
// that deny the point with the fewest denials.
DeniedPixels FindDeniedPixels(const ViewSet& views,
                              const std::vector<double>& margins,
                              size_t view,
                              const cv::Mat& pixels);

}  // namespace octacut
