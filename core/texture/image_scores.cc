#include "core/texture/image_scores.h"

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace octacut {
namespace {

constexpr int kWindow = 11;
constexpr double kWindowDeviation = 1.5;

cv::Mat Blurred(const cv::Mat& image) {
  cv::Mat result;
  cv::GaussianBlur(image, result, cv::Size(kWindow, kWindow), kWindowDeviation);
  return result;
}

cv::Mat GreyOf(const cv::Mat& image) {
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  grey.convertTo(grey, CV_64F);
  return grey;
}

}  // namespace

double ImageScores::Psnr() const {
  if (num_pixels == 0) {
    return 0;
  }
  const double mean = squared_error / double(num_pixels);
  return mean > 0 ? 10 * std::log10(255.0 * 255.0 / mean)
                  : std::numeric_limits<double>::infinity();
}

double ImageScores::Ssim() const {
  return num_windows > 0 ? ssim_sum / double(num_windows) : 0;
}

void AddScores(const cv::Mat& picture,
               const cv::Mat& photograph,
               const cv::Mat& region,
               ImageScores* scores) {
  for (int y = 0; y < region.rows; ++y) {
    for (int x = 0; x < region.cols; ++x) {
      if (region.at<uint8_t>(y, x) != 0) {
        const cv::Vec3d difference = cv::Vec3d(picture.at<cv::Vec3b>(y, x)) -
                                     cv::Vec3d(photograph.at<cv::Vec3b>(y, x));
        scores->squared_error += difference.dot(difference) / 3;
        ++scores->num_pixels;
      }
    }
  }
  const cv::Mat a = GreyOf(picture);
  const cv::Mat b = GreyOf(photograph);
  const cv::Mat mean_a = Blurred(a);
  const cv::Mat mean_b = Blurred(b);
  const cv::Mat square_a = Blurred(a.mul(a));
  const cv::Mat square_b = Blurred(b.mul(b));
  const cv::Mat product = Blurred(a.mul(b));
  cv::Mat whole;
  cv::erode(region != 0,
            whole,
            cv::Mat::ones(kWindow, kWindow, CV_8UC1),
            cv::Point(-1, -1),
            1,
            cv::BORDER_CONSTANT,
            cv::Scalar(0));
  constexpr double kC1 = (0.01 * 255) * (0.01 * 255);
  constexpr double kC2 = (0.03 * 255) * (0.03 * 255);
  for (int y = 0; y < whole.rows; ++y) {
    for (int x = 0; x < whole.cols; ++x) {
      if (whole.at<uint8_t>(y, x) == 0) {
        continue;
      }
      const double ma = mean_a.at<double>(y, x);
      const double mb = mean_b.at<double>(y, x);
      const double va = square_a.at<double>(y, x) - ma * ma;
      const double vb = square_b.at<double>(y, x) - mb * mb;
      const double vab = product.at<double>(y, x) - ma * mb;
      scores->ssim_sum += (2 * ma * mb + kC1) * (2 * vab + kC2) /
                          ((ma * ma + mb * mb + kC1) * (va + vb + kC2));
      ++scores->num_windows;
    }
  }
}

void AddNoise(const cv::Mat& photograph,
              const cv::Mat& region,
              ImageScores* scores) {
  // Blind to gradients; the squares of its weights sum to 36.
  const cv::Mat weights =
      (cv::Mat_<float>(3, 3) << 1, -2, 1, -2, 4, -2, 1, -2, 1);
  cv::Mat differences;
  cv::filter2D(photograph, differences, CV_32F, weights);
  cv::Mat inner;
  cv::erode(region != 0,
            inner,
            cv::Mat::ones(3, 3, CV_8UC1),
            cv::Point(-1, -1),
            1,
            cv::BORDER_CONSTANT,
            cv::Scalar(0));
  for (int y = 0; y < inner.rows; ++y) {
    for (int x = 0; x < inner.cols; ++x) {
      if (inner.at<uint8_t>(y, x) != 0) {
        const cv::Vec3d difference = differences.at<cv::Vec3f>(y, x);
        scores->squared_error += difference.dot(difference) / (3 * 36);
        ++scores->num_pixels;
      }
    }
  }
}

}  // namespace octacut
