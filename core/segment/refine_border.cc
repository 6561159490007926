#include "core/segment/refine_border.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/segment/colour_mixture.h"
#include "core/segment/label_cut.h"
#include "core/segment/labels.h"
#include "core/segment/pixel_features.h"
#include "core/segment/shadows.h"

namespace octacut {
namespace {

// Wider bands are first cut in a picture of a quarter of the size.
constexpr double kWidestBand = 8;
constexpr int kReduction = 4;
// By how much a border from a smaller picture can be off, in its pixels.
constexpr double kReducedReach = 1.5;
// A band is cut again around the new border while that ends at its limits, at
// most so many times (docs/experiments/mask_bands.md).
constexpr int kMaxPasses = 8;
// Colours are learned up to so many reaches from the border.
constexpr double kLearnReaches = 5;
constexpr size_t kSamples = 4000;
constexpr int kComponents = 6;
constexpr float kMostOdds = 4;
constexpr float kSmoothness = 8;

// The part of the picture that matters for the border.
cv::Rect WindowAround(const cv::Mat& mask, double reach) {
  cv::Rect box = cv::boundingRect(mask);
  const int margin = int(std::ceil((kLearnReaches + 1) * reach)) + 1;
  box -= cv::Point(margin, margin);
  box += cv::Size(2 * margin, 2 * margin);
  return box & cv::Rect(0, 0, mask.cols, mask.rows);
}

std::vector<PixelFeature> SamplesOf(const cv::Mat& features,
                                    const cv::Mat& chosen) {
  std::vector<PixelFeature> all;
  for (int y = 0; y < chosen.rows; ++y) {
    for (int x = 0; x < chosen.cols; ++x) {
      if (chosen.at<uint8_t>(y, x) != 0) {
        all.push_back(features.at<PixelFeature>(y, x));
      }
    }
  }
  if (all.size() <= kSamples) {
    return all;
  }
  std::vector<PixelFeature> samples;
  for (size_t i = 0; i < kSamples; ++i) {
    samples.push_back(all[i * all.size() / kSamples]);
  }
  return samples;
}

// Returns whether pixels at the limits of the band change sides: then the
// border may lie beyond it.
bool CutBand(const cv::Mat& image, double reach, cv::Mat* mask) {
  cv::Mat inside;
  cv::Mat outside;
  cv::distanceTransform(*mask, inside, cv::DIST_L2, cv::DIST_MASK_5);
  cv::distanceTransform(~*mask, outside, cv::DIST_L2, cv::DIST_MASK_5);
  const cv::Mat band = (inside <= reach) & (outside <= reach);
  const double learned = kLearnReaches * reach;
  const cv::Mat features = PixelFeatures(image);
  const ColourMixture object(
      SamplesOf(features, (inside > reach) & (inside < learned)), kComponents);
  std::vector<PixelFeature> outer =
      SamplesOf(features, (outside > reach) & (outside < learned));
  AddShadows(&outer);
  const ColourMixture surroundings(outer, kComponents);
  cv::Mat log_odds(image.size(), CV_32F, cv::Scalar(0));
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      if (band.at<uint8_t>(y, x) != 0) {
        const PixelFeature& feature = features.at<PixelFeature>(y, x);
        log_odds.at<float>(y, x) = std::clamp(
            std::log(object.Density(feature) / surroundings.Density(feature)),
            -kMostOdds,
            kMostOdds);
      }
    }
  }
  const cv::Mat limits = band & ((inside > reach - 1) | (outside > reach - 1));
  const cv::Mat before = mask->clone();
  mask->setTo(kNoLabel, band);
  CutLabels(image, log_odds, kSmoothness, mask);
  return cv::countNonZero((*mask != before) & limits) > 0;
}

}  // namespace

cv::Mat RefineBorder(const cv::Mat& image, const cv::Mat& mask, double reach) {
  cv::Mat result = mask.clone();
  if (cv::countNonZero(mask) == 0) {
    return result;
  }
  if (reach > kWidestBand && std::min(image.rows, image.cols) >= kReduction) {
    const cv::Size size(image.cols / kReduction, image.rows / kReduction);
    cv::Mat small_image;
    cv::Mat small_mask;
    cv::resize(image, small_image, size, 0, 0, cv::INTER_AREA);
    cv::resize(mask, small_mask, size, 0, 0, cv::INTER_AREA);
    const cv::Mat small =
        RefineBorder(small_image, small_mask > 127, reach / kReduction);
    cv::resize(small, result, image.size(), 0, 0, cv::INTER_LINEAR);
    result = result > 127;
    reach = kReducedReach * kReduction;
  }
  bool is_limited = true;
  for (int pass = 0; is_limited && pass < kMaxPasses; ++pass) {
    const cv::Rect window = WindowAround(result, reach);
    cv::Mat inner = result(window);
    is_limited =
        cv::countNonZero(inner) > 0 && CutBand(image(window), reach, &inner);
  }
  return result;
}

}  // namespace octacut
