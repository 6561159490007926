// What a pixel looks like to the models of object and surroundings.
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/matx.hpp>
#include <vector>

namespace octacut {

// L (0 to 100), a and b of CIE Lab, and the roughness of the surroundings.
using PixelFeature = cv::Vec4f;

// The features of every pixel of `image` (CV_8UC3, BGR), as CV_32FC4.
//
// Roughness is r = 10 log(1 + s), with the standard deviation s of L in a
// window of 5 x 5 pixels: of all windows that hold the pixel, that of the least
// s. So it does not grow at the border of a smooth object, where windows around
// the pixel would hold some of both sides.
cv::Mat PixelFeatures(const cv::Mat& image);

// Features (as PixelFeatures has them) of the pixels that are set in `chosen`
// (CV_8UC1), at most `limit`, evenly taken.
std::vector<PixelFeature> SampleFeatures(const cv::Mat& features,
                                         const cv::Mat& chosen,
                                         size_t limit);

}  // namespace octacut
