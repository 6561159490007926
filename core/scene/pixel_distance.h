// Distances between pixels of masks, and to their frames.
#pragma once

#include <opencv2/core/mat.hpp>

namespace octacut {

// The distance of each pixel of `image` (CV_8UC1) that is not 0 to the nearest
// one that is; 0 elsewhere. CV_32FC1, pixels.
cv::Mat DistancesToZero(const cv::Mat& image);

// CV_8UC1, 255: the pixels that are not 0 in `marked`, and those at most
// `radius` pixels from one.
cv::Mat PixelsNear(const cv::Mat& marked, double radius);

// Whether `box` holds pixels at the border of the frame.
bool TouchesFrame(const cv::Rect& box, const cv::Size& frame);

}  // namespace octacut
