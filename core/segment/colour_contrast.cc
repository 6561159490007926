#include "core/segment/colour_contrast.h"

#include <algorithm>
#include <cmath>

namespace octacut {
namespace {

constexpr int kContrastComponents = 8;

}  // namespace

ColourContrast::ColourContrast(std::span<const PixelFeature> object,
                               std::span<const PixelFeature> surroundings)
    : object_(object, kContrastComponents),
      surroundings_(surroundings, kContrastComponents) {}

cv::Mat ColourContrast::LogOdds(const cv::Mat& features,
                                const cv::Mat& chosen) const {
  cv::Mat log_odds = cv::Mat::zeros(features.size(), CV_32F);
  for (int y = 0; y < features.rows; ++y) {
    for (int x = 0; x < features.cols; ++x) {
      if (chosen.at<uint8_t>(y, x) != 0) {
        const PixelFeature& feature = features.at<PixelFeature>(y, x);
        log_odds.at<float>(y, x) = std::clamp(
            std::log(object_.Density(feature) / surroundings_.Density(feature)),
            -kMostOdds,
            kMostOdds);
      }
    }
  }
  return log_odds;
}

}  // namespace octacut
