// The border between object and background in one picture, as a minimal cut.
#pragma once

#include <opencv2/core/mat.hpp>

namespace octacut {

// Decides every pixel of `labels` (CV_8UC1) that is kNoLabel; the others
// stay as they are. Minimizes
//   sum over pixels labelled background of their log odds (CV_32F)
//   + smoothness * sum over neighbours with different labels of
//     exp(-beta |difference of colour|^2) / distance
// over 8-neighbourhoods of `image` (CV_8UC3), all of one size, with beta from
// the mean difference, as Y. Boykov and M.-P. Jolly (ICCV 2001) and C. Rother,
// V. Kolmogorov and A. Blake ("GrabCut", SIGGRAPH 2004) have it.
void CutLabels(const cv::Mat& image,
               const cv::Mat& log_odds,
               float smoothness,
               cv::Mat* labels);

}  // namespace octacut
