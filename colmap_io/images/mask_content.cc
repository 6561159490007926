#include "colmap_io/images/mask_content.h"

#include <opencv2/core.hpp>

namespace octacut {

MaskContent ContentOfMask(const cv::Mat& object) {
  const size_t count = size_t(cv::countNonZero(object));
  if (count == 0) {
    return MaskContent::kAllBackground;
  }
  return count == object.total() ? MaskContent::kAllObject
                                 : MaskContent::kOutline;
}

bool BorderIsObject(const cv::Mat& object) {
  return cv::countNonZero(object.row(0)) == object.cols &&
         cv::countNonZero(object.row(object.rows - 1)) == object.cols &&
         cv::countNonZero(object.col(0)) == object.rows &&
         cv::countNonZero(object.col(object.cols - 1)) == object.rows;
}

}  // namespace octacut
