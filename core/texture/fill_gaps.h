// Pixels without a value get that of their surroundings.
#pragma once

#include <opencv2/core/mat.hpp>

namespace octacut {

// Means of ever larger blocks of known pixels fill the others of `image`
// (CV_8UC3): the "pull-push" of S. Gortler et al. ("The Lumigraph", SIGGRAPH
// 1996). `known` is CV_8UC1, not 0 where a pixel is known; such pixels stay. An
// image without any known pixel is left as it is.
void FillGaps(const cv::Mat& known, cv::Mat* image);

}  // namespace octacut
