// The picture beside a run's report.
#pragma once

#include <opencv2/core/mat.hpp>

namespace octacut {

// Two pictures side by side with a margin between them; the second is scaled
// to the first one's height. Both CV_8UC3 and not empty.
cv::Mat ComposeComparison(const cv::Mat& photograph, const cv::Mat& shaded);

}  // namespace octacut
