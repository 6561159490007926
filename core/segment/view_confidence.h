// How far the silhouette that was found in a view can be trusted.
#pragma once

#include <opencv2/core/mat.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/segment/segment_object.h"

namespace octacut {

struct ViewConfidence {
  // Overlap (intersection over union) of the silhouette with what the other
  // views leave for it, pixels within two of either border not counted.
  double agreement = 0;
  // Part of the border where the colours on both sides are those of object and
  // surroundings.
  double contrast = 0;
  // The product of both: 0 to 1.
  double confidence = 0;
  // Radius of the largest disc that the others surely call object and the
  // silhouette does not, over the square root of the silhouette's area.
  double lost = 0;
  // Why the view is not trusted, as a part of a sentence; empty when it is.
  std::string doubt;
};

// Part of the border of `mask` (CV_8UC1, 0 or 255) where log odds (CV_32F of
// that size) say object inside and background outside, of both the lesser.
double BorderContrast(const cv::Mat& mask, const cv::Mat& log_odds);

// `masks` are the final silhouettes at the size of the segmented views, CV_8UC1
// of 0 and 255. A view is not trusted when its silhouette is empty, when half
// of it or of its border is in doubt, or when it agrees with the others far
// less than is usual among these views (where few views carve the object, what
// they leave is larger for all of them), or when it lacks a thicker part than
// is usual that the others surely show (docs/experiments/mask_lost.md).
std::vector<ViewConfidence> JudgeViews(const Segmentation& segmentation,
                                       std::span<const cv::Mat> masks);

}  // namespace octacut
