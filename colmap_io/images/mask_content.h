// What a mask shows as a whole.
#pragma once

#include <opencv2/core/mat.hpp>

namespace octacut {

enum class MaskContent {
  kOutline,        // object and background
  kAllBackground,  // of an image without the object, or a failed segmentation
  kAllObject,
};

// `object` is CV_8UC1 and not zero where the mask is object.
MaskContent ContentOfMask(const cv::Mat& object);

// True when every pixel at the mask's border is object: of an object that
// fills the frame, and of a mask that is inverted.
bool BorderIsObject(const cv::Mat& object);

}  // namespace octacut
