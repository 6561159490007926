// What the other views show at the pixels of a view.
//
// Their consensus on a pixel (CV_32F of the view's size) is 1 where they surely
// show the object, and -1 where they surely show background.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/segment/occupancy.h"

namespace octacut {

cv::Mat ConsensusOfOthers(const OccupancyGrid& grid, size_t view);

// Log odds of the object by that consensus (CV_32F).
cv::Mat EvidenceOfOthers(const cv::Mat& others);

// The pixels (CV_8UC1, 0 or 255) that the other views exclude: whatever they
// look like, they are background, unless labels say otherwise.
cv::Mat ExcludedByOthers(const cv::Mat& others);

// The pixels (CV_8UC1, 0 or 255) that the `num_others` other views surely show
// as object: they say half of what they would if all were sure, or more, or so
// much that two could deny it. One that denies a point takes away what eleven
// say.
cv::Mat ShownByOthers(const cv::Mat& others, size_t num_others);

}  // namespace octacut
