#include "core/texture/fill_gaps.h"

#include <opencv2/core.hpp>

namespace octacut {

void FillGaps(const cv::Mat& known, cv::Mat* image) {
  if (image->rows == 1 && image->cols == 1) {
    return;
  }
  const cv::Size size((image->cols + 1) / 2, (image->rows + 1) / 2);
  cv::Mat coarse(size, CV_8UC3, cv::Scalar::all(0));
  cv::Mat coarse_known(size, CV_8UC1, cv::Scalar(0));
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      cv::Vec3i sum(0, 0, 0);
      int count = 0;
      for (int j = 2 * y; j < std::min(2 * y + 2, image->rows); ++j) {
        for (int i = 2 * x; i < std::min(2 * x + 2, image->cols); ++i) {
          if (known.at<uint8_t>(j, i) != 0) {
            sum += cv::Vec3i(image->at<cv::Vec3b>(j, i));
            ++count;
          }
        }
      }
      if (count > 0) {
        for (int c = 0; c < 3; ++c) {
          coarse.at<cv::Vec3b>(y, x)[c] = uint8_t((sum[c] + count / 2) / count);
        }
        coarse_known.at<uint8_t>(y, x) = 255;
      }
    }
  }
  FillGaps(coarse_known, &coarse);
  for (int y = 0; y < image->rows; ++y) {
    for (int x = 0; x < image->cols; ++x) {
      if (known.at<uint8_t>(y, x) == 0) {
        image->at<cv::Vec3b>(y, x) = coarse.at<cv::Vec3b>(y / 2, x / 2);
      }
    }
  }
}

}  // namespace octacut
