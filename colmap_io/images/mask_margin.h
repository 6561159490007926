// Masks that are known to be too small or too large.
#pragma once

#include <opencv2/core/mat.hpp>

namespace octacut {

inline constexpr int kMaxMaskMargin = 64;

// The object of a mask grown by `margin` pixels all around, or shrunk where
// that is negative. Values between 0 and 255 move along with their border;
// beyond the frame there is what its border shows.
cv::Mat WithMargin(const cv::Mat& mask, int margin);

}  // namespace octacut
