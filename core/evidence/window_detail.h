// How much of a view there is to match. For core/evidence alone.
#pragma once

#include <opencv2/core/mat.hpp>

namespace octacut {

// For each sample of a reduced view, the share of the windows around it whose
// grey values deviate by `deviation` or more from the plane that fits them
// best. A linear change, as the shading of a plain surface shows it, correlates
// with any other at any depth, and highlights with those of a surface that is
// not there (docs/experiments/dents.md).
cv::Mat1f ShareWithDetail(const cv::Mat1f& grey,
                          int window_radius,
                          float deviation);

}  // namespace octacut
