// Masks made larger or smaller.
#pragma once

#include <opencv2/core/mat.hpp>

namespace octacut {

// The object of a mask (CV_8UC1) grown by `pixels` all around, or shrunk where
// that is negative. Values between 0 and 255 move along with their border;
// beyond the frame there is what its border shows.
cv::Mat MoveMaskBorder(const cv::Mat& mask, int pixels);

}  // namespace octacut
