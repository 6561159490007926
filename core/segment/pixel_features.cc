#include "core/segment/pixel_features.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace octacut {
namespace {

constexpr int kWindow = 5;
constexpr float kRoughnessScale = 10;

cv::Mat Roughness(const cv::Mat& lightness) {
  const cv::Size window(kWindow, kWindow);
  cv::Mat mean;
  cv::Mat mean_of_squares;
  cv::boxFilter(lightness, mean, CV_32F, window);
  cv::sqrBoxFilter(lightness, mean_of_squares, CV_32F, window);
  cv::Mat roughness(lightness.size(), CV_32F);
  for (int y = 0; y < roughness.rows; ++y) {
    for (int x = 0; x < roughness.cols; ++x) {
      const float m = mean.at<float>(y, x);
      const float variance =
          std::max(0.0f, mean_of_squares.at<float>(y, x) - m * m);
      roughness.at<float>(y, x) =
          kRoughnessScale * std::log1p(std::sqrt(variance));
    }
  }
  cv::erode(roughness, roughness, cv::Mat::ones(window, CV_8U));
  return roughness;
}

}  // namespace

cv::Mat PixelFeatures(const cv::Mat& image) {
  cv::Mat lab;
  image.convertTo(lab, CV_32FC3, 1.0 / 255);
  cv::cvtColor(lab, lab, cv::COLOR_BGR2Lab);
  cv::Mat lightness;
  cv::extractChannel(lab, lightness, 0);
  cv::Mat features;
  cv::merge(std::vector<cv::Mat>{lab, Roughness(lightness)}, features);
  return features;
}

std::vector<PixelFeature> SampleFeatures(const cv::Mat& features,
                                         const cv::Mat& chosen,
                                         size_t limit) {
  std::vector<PixelFeature> all;
  for (int y = 0; y < chosen.rows; ++y) {
    for (int x = 0; x < chosen.cols; ++x) {
      if (chosen.at<uint8_t>(y, x) != 0) {
        all.push_back(features.at<PixelFeature>(y, x));
      }
    }
  }
  if (all.size() <= limit) {
    return all;
  }
  std::vector<PixelFeature> samples;
  for (size_t i = 0; i < limit; ++i) {
    samples.push_back(all[i * all.size() / limit]);
  }
  return samples;
}

}  // namespace octacut
