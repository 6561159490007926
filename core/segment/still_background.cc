#include "core/segment/still_background.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "core/base/median.h"
#include "core/base/parallel.h"
#include "core/base/parallel_pixels.h"

namespace octacut {
namespace {

// Photographs whose values are tried as the background's, evenly taken. One
// that a quarter of the photographs shows is among them almost surely.
constexpr size_t kCandidates = 16;
// Lower quartile of the length of a vector of three normal deviates, and of
// how many standard deviations two photographs may differ.
constexpr float kQuartile = 1.10f;
constexpr float kDeviations = 3.5f;
// JPEG's own errors, and strong noise, in 8 bits.
constexpr float kLeastTolerance = 8;
constexpr float kMostTolerance = 25;
// Noise makes the colours of the background scatter; those of a surface that
// changes within the tolerance scatter up to three times as much.
constexpr float kVaries = 2;
// The least noise in 8 bits, by rounding.
constexpr float kLeastNoise = 0.5f;
// Part of the photographs that show what is surely background.
constexpr float kMostPhotographs = 0.5f;
// Least light in a shadow; L + 16 goes with its cube root.
constexpr float kLeastLightOfShadow = 0.4f;
constexpr float kBlackInLab = 16 * 2.55f;
constexpr float kNeutral = 128;  // of a and b

float Distance(const cv::Vec3b& a, const cv::Vec3f& b) {
  const float x = float(a[0]) - b[0];
  const float y = float(a[1]) - b[1];
  const float z = float(a[2]) - b[2];
  return std::sqrt(x * x + y * y + z * z);
}

// From the differences between neighbouring photographs.
float Tolerance(std::span<const cv::Mat> labs) {
  std::vector<float> quartiles;
  for (size_t i = 0; i + 1 < labs.size(); ++i) {
    std::vector<float> distances;
    for (int y = 0; y < labs[i].rows; y += 3) {
      for (int x = 0; x < labs[i].cols; x += 3) {
        distances.push_back(
            Distance(labs[i].at<cv::Vec3b>(y, x),
                     cv::Vec3f(labs[i + 1].at<cv::Vec3b>(y, x))));
      }
    }
    const auto point = distances.begin() + ptrdiff_t(distances.size() / 4);
    std::nth_element(distances.begin(), point, distances.end());
    quartiles.push_back(*point);
  }
  if (quartiles.empty()) {
    return kLeastTolerance;
  }
  return std::clamp(kDeviations * Median(std::move(quartiles)) / kQuartile,
                    kLeastTolerance,
                    kMostTolerance);
}

// The mean of the values that most photographs agree on.
cv::Vec3f MostFrequent(std::span<const cv::Mat> labs,
                       int y,
                       int x,
                       float tolerance) {
  const size_t count = std::min(kCandidates, labs.size());
  cv::Vec3f best;
  int most = 0;
  for (size_t k = 0; k < count; ++k) {
    const cv::Vec3f candidate(
        labs[k * labs.size() / count].at<cv::Vec3b>(y, x));
    cv::Vec3f sum(0, 0, 0);
    int votes = 0;
    for (const cv::Mat& lab : labs) {
      const auto& value = lab.at<cv::Vec3b>(y, x);
      if (Distance(value, candidate) < tolerance) {
        sum += cv::Vec3f(value);
        ++votes;
      }
    }
    if (votes > most) {
      most = votes;
      best = sum / float(votes);
    }
  }
  return best;
}

// CV_32F: how far the photographs that show the background scatter about it,
// the mean of windows.
cv::Mat Scatter(std::span<const cv::Mat> labs,
                const StillBackground& background,
                const Context& context) {
  cv::Mat scatter(background.color.size(), CV_32F);
  ParallelPixels(context, scatter.cols, scatter.rows, [&](int x, int y) {
    float sum = 0;
    int count = 0;
    for (const cv::Mat& lab : labs) {
      const float distance = Distance(lab.at<cv::Vec3b>(y, x),
                                      background.color.at<cv::Vec3f>(y, x));
      if (distance < background.tolerance) {
        sum += distance * distance;
        ++count;
      }
    }
    scatter.at<float>(y, x) = std::sqrt(sum / float(std::max(count, 1)));
  });
  return WindowMean(scatter);
}

// The share of the masks that are set, for each pixel.
cv::Mat PartOf(const std::vector<cv::Mat>& masks) {
  cv::Mat sum = cv::Mat::zeros(masks.front().size(), CV_32F);
  for (const cv::Mat& mask : masks) {
    cv::accumulate(mask, sum);
  }
  return sum / (255.0 * double(masks.size()));
}

}  // namespace

int WideWindow(const cv::Size& size) {
  return std::max(kStillWindow, std::max(size.width, size.height) / 50 * 2 + 1);
}

cv::Mat WindowMean(const cv::Mat& values, int window) {
  cv::Mat mean;
  cv::boxFilter(values, mean, CV_32F, {window, window});
  return mean;
}

cv::Mat ToLab(const cv::Mat& image) {
  cv::Mat lab;
  cv::cvtColor(image, lab, cv::COLOR_BGR2Lab);
  return lab;
}

cv::Mat LooksLike(const cv::Mat& lab, const cv::Mat& color, float tolerance) {
  cv::Mat same(lab.size(), CV_32F);
  for (int y = 0; y < lab.rows; ++y) {
    for (int x = 0; x < lab.cols; ++x) {
      const float distance =
          Distance(lab.at<cv::Vec3b>(y, x), color.at<cv::Vec3f>(y, x));
      same.at<float>(y, x) = distance < tolerance ? 1.0f : 0.0f;
    }
  }
  return same;
}

StillBackground FindStillBackground(std::span<const cv::Mat> labs,
                                    const Context& context) {
  const cv::Size size = labs.front().size();
  StillBackground background;
  background.tolerance = Tolerance(labs);
  background.color.create(size, CV_32FC3);
  ParallelPixels(context, size.width, size.height, [&](int x, int y) {
    background.color.at<cv::Vec3f>(y, x) =
        MostFrequent(labs, y, x, background.tolerance);
  });
  std::vector<cv::Mat> shown(labs.size());
  std::vector<cv::Mat> widely_shown(labs.size());
  const int wide = WideWindow(size);
  ParallelEach(context, labs.size(), 1, [&](size_t i) {
    const cv::Mat same =
        LooksLike(labs[i], background.color, background.tolerance);
    shown[i] = WindowMean(same) >= kMostOfWindow;  // 255 where it is
    widely_shown[i] = WindowMean(same, wide) >= kMostOfWindow;
  });
  background.support = PartOf(shown);
  background.wide_support = PartOf(widely_shown);
  return background;
}

cv::Mat WhatVaries(std::span<const cv::Mat> labs,
                   const StillBackground& background,
                   const Context& context) {
  const cv::Mat scatter = Scatter(labs, background, context);
  std::vector<float> noise;  // of what most photographs show
  for (int y = 0; y < scatter.rows; ++y) {
    for (int x = 0; x < scatter.cols; ++x) {
      if (background.support.at<float>(y, x) > kMostPhotographs) {
        noise.push_back(scatter.at<float>(y, x));
      }
    }
  }
  return noise.empty()
             ? cv::Mat::zeros(scatter.size(), CV_8U)
             : cv::Mat(scatter > kVaries * std::max(Median(std::move(noise)),
                                                    kLeastNoise));
}

cv::Mat DistanceFromBackground(const cv::Mat& lab,
                               const StillBackground& background) {
  static const float kLeast = std::cbrt(kLeastLightOfShadow);
  cv::Mat distance(lab.size(), CV_32F);
  for (int y = 0; y < lab.rows; ++y) {
    for (int x = 0; x < lab.cols; ++x) {
      const auto& value = lab.at<cv::Vec3b>(y, x);
      const auto& color = background.color.at<cv::Vec3f>(y, x);
      const float light =
          std::clamp((float(value[0]) + kBlackInLab) / (color[0] + kBlackInLab),
                     kLeast,
                     1.0f);
      const cv::Vec3f shaded((color[0] + kBlackInLab) * light - kBlackInLab,
                             (color[1] - kNeutral) * light + kNeutral,
                             (color[2] - kNeutral) * light + kNeutral);
      const float in_light = Distance(value, color) / background.tolerance;
      const float in_shadow = Distance(value, shaded) / background.tolerance;
      distance.at<float>(y, x) =
          in_light < 1 ? in_light : std::max(1.0f, in_shadow);
    }
  }
  return distance;
}

}  // namespace octacut
