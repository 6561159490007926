// All views on one picture, so that a person sees at a look whether to trust
// their masks.
#pragma once

#include <opencv2/core/mat.hpp>
#include <span>

#include "colmap_io/images/mask_list.h"
#include "core/segment/segment_object.h"

namespace octacut {

// Each view with the outline of its mask (CV_8UC1, of the view's size), its
// name and its confidence, the least confident first. Outlines are green, those
// of unsure views red, those of given masks blue. `list` is in the order of the
// views.
cv::Mat DrawContactSheet(std::span<const UnsegmentedView> views,
                         std::span<const cv::Mat> masks,
                         const MaskList& list);

}  // namespace octacut
