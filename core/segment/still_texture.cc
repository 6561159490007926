#include "core/segment/still_texture.h"

#include <opencv2/imgproc.hpp>

namespace octacut {
namespace {

constexpr int kLeastAgreeing = 2;
// A turn has at most so many steps: in less than 10 degrees, the shading of an
// object moves too little.
constexpr size_t kStepsOfTurn = 36;
// With fewer, those around one of them are not four others.
constexpr size_t kLeastPhotographs = 5;
// Standard deviation of the lightness in a window, in tolerances.
constexpr double kLeastDeviation = 1;
// Squared grey levels, by rounding.
constexpr double kRoundingVariance = 0.25;
// Part of a window that differs from the most frequent colours, and how its
// lightness may correlate with theirs.
constexpr double kLeastOther = 0.3;
constexpr double kMostCorrelation = 0.5;
// The smaller eigenvalue of the structure tensor, as a part of the larger one.
constexpr double kLeastAcross = 0.1;

cv::Mat Lightness(const cv::Mat& lab) {
  cv::Mat lightness;
  cv::extractChannel(lab, lightness, 0);
  lightness.convertTo(lightness, CV_32F);
  return lightness;
}

cv::Mat Covariance(const cv::Mat& a, const cv::Mat& b) {
  return WindowMean(a.mul(b)) - WindowMean(a).mul(WindowMean(b));
}

// Where a photograph has texture that the most frequent colours do not have.
cv::Mat OwnTexture(const cv::Mat& lightness,
                   const cv::Mat& most_frequent,
                   double tolerance) {
  const cv::Mat variance = Covariance(lightness, lightness);
  const cv::Mat covariance = Covariance(lightness, most_frequent);
  const cv::Mat other =
      cv::max(Covariance(most_frequent, most_frequent), kRoundingVariance);
  const cv::Mat limit =
      kMostCorrelation * kMostCorrelation * variance.mul(other);
  const double least = kLeastDeviation * tolerance;
  return (variance > least * least) &
         ((covariance < 0) | (covariance.mul(covariance) < limit));
}

// Where the lightness changes in more than one direction, as far as there is
// texture.
cv::Mat ManyDirections(const cv::Mat& lightness,
                       const cv::Mat& texture,
                       int window) {
  cv::Mat x;
  cv::Mat y;
  cv::Sobel(lightness, x, CV_32F, 1, 0);
  cv::Sobel(lightness, y, CV_32F, 0, 1);
  x.setTo(0, texture == 0);
  y.setTo(0, texture == 0);
  const cv::Mat xx = WindowMean(x.mul(x), window);
  const cv::Mat yy = WindowMean(y.mul(y), window);
  const cv::Mat xy = WindowMean(x.mul(y), window);
  const cv::Mat trace = xx + yy;
  // The determinant by the squared trace, of just this ratio of eigenvalues.
  constexpr double kLimit =
      kLeastAcross / ((1 + kLeastAcross) * (1 + kLeastAcross));
  return xx.mul(yy) - xy.mul(xy) > kLimit * trace.mul(trace);
}

// Where two of four photographs around the i-th one show what it does.
cv::Mat StandsStill(std::span<const cv::Mat> labs, size_t i, float tolerance) {
  const size_t count = labs.size();
  const size_t apart = (count + kStepsOfTurn - 1) / kStepsOfTurn;
  cv::Mat votes = cv::Mat::zeros(labs[i].size(), CV_8U);
  for (const size_t step :
       {apart, 2 * apart, count - 2 * apart, count - apart}) {
    cv::Mat other;
    labs[(i + step) % count].convertTo(other, CV_32F);
    const cv::Mat same = WindowMean(LooksLike(labs[i], other, tolerance));
    votes += (same >= kMostOfWindow) / 255;
  }
  return votes >= kLeastAgreeing;
}

}  // namespace

StillTexture FindStillTexture(std::span<const cv::Mat> labs,
                              size_t i,
                              const StillBackground& background) {
  StillTexture result(labs[i].size());
  if (labs.size() < kLeastPhotographs) {
    return result;
  }
  const float tolerance = background.tolerance;
  const cv::Mat lightness = Lightness(labs[i]);
  const cv::Mat is_still = StandsStill(labs, i, tolerance);
  const cv::Mat usual =
      WindowMean(LooksLike(labs[i], background.color, tolerance));
  const cv::Mat texture =
      is_still & (usual < 1 - kLeastOther) &
      OwnTexture(lightness, Lightness(background.color), tolerance);
  const int wide = WideWindow(lightness.size());
  result.sure = texture & ManyDirections(lightness, texture, wide);
  cv::dilate(result.sure, result.near, cv::Mat::ones(wide, wide, CV_8U));
  result.near &= is_still;
  return result;
}

}  // namespace octacut
