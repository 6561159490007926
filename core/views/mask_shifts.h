// Single masks whose borders are off: by another tool than the others, by a
// slip of the hand, or each by other pixels.
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/context.h"
#include "core/views/view_set.h"

namespace octacut {

struct MaskShift {
  size_t view = 0;
  // By which the border lies outside where it should be.
  double pixels = 0;
};

// The masks whose borders lie more than two pixels from where those of most
// views lie, by the edges of their photographs within sixteen pixels; from
// these edges themselves where fewer than three quarters of the masks agree.
// What all masks have in common stays: see border_edges.h.
std::vector<MaskShift> FindMaskShifts(const ViewSet& views,
                                      const Context& context);

// A mask (CV_8UC1) of that size whose border lies so many pixels farther
// inside.
cv::Mat MoveBorderInside(const Silhouette& silhouette,
                         const cv::Size& size,
                         double pixels);

}  // namespace octacut
