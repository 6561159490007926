// Photographs of discs, and masks that are larger or smaller.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>

#include "core/views/view_set.h"
#include "tests/core/views/random_views.h"

namespace octacut::testing {

inline constexpr int kDiscImageSize = 240;
inline constexpr double kDiscRadius = 80;

// The share of a pixel's area that a disc around the middle covers.
inline double DiscCoverage(int x, int y, double radius) {
  constexpr int kSamples = 8;
  int count = 0;
  for (int i = 0; i < kSamples * kSamples; ++i) {
    const double u = x + (i % kSamples + 0.5) / kSamples - kDiscImageSize / 2.0;
    const int row = i / kSamples;
    const double v = y + (row + 0.5) / kSamples - kDiscImageSize / 2.0;
    count += u * u + v * v < radius * radius ? 1 : 0;
  }
  return double(count) / (kSamples * kSamples);
}

inline uint8_t Grey(double linear) {
  return uint8_t(std::lround(255 * std::pow(linear, 1 / 2.2)));
}

inline PreparedView ViewOf(const cv::Mat& image, const cv::Mat& mask) {
  PreparedView view;
  view.silhouette = Silhouette(mask);
  view.pyramid = ImagePyramid(image, mask);
  return view;
}

// A disc of linear light `object` before `background`, and a mask whose disc is
// larger by `shift` pixels; `noise` grey levels at most.
inline PreparedView MakeDiscView(double shift,
                                 double object,
                                 double background,
                                 int noise = 2) {
  Random random(7);
  cv::Mat image(kDiscImageSize, kDiscImageSize, CV_8UC3);
  cv::Mat mask(kDiscImageSize, kDiscImageSize, CV_8UC1);
  for (int y = 0; y < kDiscImageSize; ++y) {
    for (int x = 0; x < kDiscImageSize; ++x) {
      const double covered = DiscCoverage(x, y, kDiscRadius);
      const double light =
          std::min(1.0, covered * object + (1 - covered) * background);
      for (int c = 0; c < 3; ++c) {
        image.at<cv::Vec3b>(y, x)[c] = cv::saturate_cast<uint8_t>(
            Grey(light) + random.Integer(-noise, noise));
      }
      mask.at<uint8_t>(y, x) =
          uint8_t(std::lround(255 * DiscCoverage(x, y, kDiscRadius + shift)));
    }
  }
  return ViewOf(image, mask);
}

}  // namespace octacut::testing
