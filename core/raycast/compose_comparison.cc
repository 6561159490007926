#include "core/raycast/compose_comparison.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/check_option.h"

namespace octacut {

cv::Mat ComposeComparison(const cv::Mat& photograph, const cv::Mat& shaded) {
  CheckOption(photograph.type() == CV_8UC3 && !photograph.empty(),
              "photograph",
              photograph.type(),
              "must be CV_8UC3 and not empty");
  CheckOption(shaded.type() == CV_8UC3 && !shaded.empty(),
              "shaded",
              shaded.type(),
              "must be CV_8UC3 and not empty");
  cv::Mat scaled = shaded;
  if (shaded.rows != photograph.rows) {
    const double factor = static_cast<double>(photograph.rows) / shaded.rows;
    const int cols =
        std::max(1, static_cast<int>(std::lround(factor * shaded.cols)));
    cv::resize(shaded,
               scaled,
               {cols, photograph.rows},
               0,
               0,
               factor < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
  }
  const int margin = std::max(2, photograph.rows / 64);
  cv::Mat picture(photograph.rows,
                  photograph.cols + margin + scaled.cols,
                  CV_8UC3,
                  cv::Scalar::all(255));
  photograph.copyTo(picture(cv::Rect(0, 0, photograph.cols, photograph.rows)));
  scaled.copyTo(
      picture(cv::Rect(photograph.cols + margin, 0, scaled.cols, scaled.rows)));
  return picture;
}

}  // namespace octacut
