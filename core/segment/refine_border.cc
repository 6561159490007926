#include "core/segment/refine_border.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/segment/border_colours.h"
#include "core/segment/label_cut.h"
#include "core/segment/labels.h"
#include "core/segment/pixel_features.h"

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
constexpr float kMostOdds = 4;
constexpr float kBorderSmoothness = 8;

// The part of the picture that matters for the border.
cv::Rect WindowAround(const cv::Mat& mask, double reach) {
  cv::Rect box = cv::boundingRect(mask);
  const int margin =
      int(std::ceil((BorderColours::kLearnReaches + 1) * reach)) + 1;
  box -= cv::Point(margin, margin);
  box += cv::Size(2 * margin, 2 * margin);
  return box & cv::Rect(0, 0, mask.cols, mask.rows);
}

// The distances of pixels from the border of a mask, 0 on its other side.
struct BorderDistances {
  explicit BorderDistances(const cv::Mat& mask) {
    cv::distanceTransform(mask, inside, cv::DIST_L2, cv::DIST_MASK_5);
    cv::distanceTransform(~mask, outside, cv::DIST_L2, cv::DIST_MASK_5);
  }

  cv::Mat inside;
  cv::Mat outside;
};

void ApplyLabels(const cv::Mat& labels, cv::Mat* mask) {
  if (!labels.empty()) {
    labels.copyTo(*mask, labels != kNoLabel);
  }
}

// Labels of which most of a pixel of the smaller size has the same.
cv::Mat ReduceLabels(const cv::Mat& labels, const cv::Size& size) {
  cv::Mat reduced(size, CV_8U, cv::Scalar(kNoLabel));
  for (const uint8_t label : {kSurroundingsLabel, kObjectLabel}) {
    cv::Mat part;
    cv::resize(labels == label, part, size, 0, 0, cv::INTER_AREA);
    reduced.setTo(label, part > 127);
  }
  return reduced;
}

// The colours to either side of a border, and the cut between them.
class BandCutter {
 public:
  // Learns from what is farther than `reach` from the border.
  BandCutter(const cv::Mat& image,
             const BorderDistances& distances,
             double reach)
      : image_(image),
        reach_(reach),
        features_(PixelFeatures(image)),
        colours_(features_, distances.inside, distances.outside, reach) {}

  // Cuts the band around the border of `mask`, whose distances are given, but
  // for what has `labels` (may be empty). Returns whether pixels at the limits
  // of the band change sides: then the border may lie beyond it.
  bool Cut(const BorderDistances& distances,
           const cv::Mat& labels,
           cv::Mat* mask) const {
    const cv::Mat to_border = cv::max(distances.inside, distances.outside);
    const cv::Mat band = to_border <= reach_;
    const cv::Mat limits = band & (to_border > reach_ - 1);
    const cv::Mat before = mask->clone();
    mask->setTo(kNoLabel, band);
    ApplyLabels(labels, mask);
    CutLabels(image_, LogOdds(band), kBorderSmoothness, mask);
    return cv::countNonZero((*mask != before) & limits) > 0;
  }

 private:
  cv::Mat LogOdds(const cv::Mat& band) const {
    cv::Mat log_odds(band.size(), CV_32F, cv::Scalar(0));
    for (int y = 0; y < band.rows; ++y) {
      for (int x = 0; x < band.cols; ++x) {
        if (band.at<uint8_t>(y, x) != 0) {
          log_odds.at<float>(y, x) = std::clamp(
              colours_.LogOdds(y, x, features_.at<PixelFeature>(y, x)),
              -kMostOdds,
              kMostOdds);
        }
      }
    }
    return log_odds;
  }

  cv::Mat image_;
  double reach_;
  cv::Mat features_;
  BorderColours colours_;
};

}  // namespace

cv::Mat RefineBorder(const cv::Mat& image,
                     const cv::Mat& mask,
                     double reach,
                     const cv::Mat& labels) {
  cv::Mat result = mask.clone();
  if (reach > kWidestBand && std::min(image.rows, image.cols) >= kReduction) {
    const cv::Size size(image.cols / kReduction, image.rows / kReduction);
    cv::Mat small_image;
    cv::Mat small_mask;
    cv::resize(image, small_image, size, 0, 0, cv::INTER_AREA);
    cv::resize(mask, small_mask, size, 0, 0, cv::INTER_AREA);
    const cv::Mat small =
        RefineBorder(small_image,
                     small_mask > 127,
                     reach / kReduction,
                     labels.empty() ? cv::Mat() : ReduceLabels(labels, size));
    cv::resize(small, result, image.size(), 0, 0, cv::INTER_LINEAR);
    result = result > 127;
    reach = kReducedReach * kReduction;
  }
  ApplyLabels(labels, &result);
  if (cv::countNonZero(result) == 0) {
    return result;
  }
  const cv::Rect window = WindowAround(result, reach);
  cv::Mat inner = result(window);
  const cv::Mat inner_labels = labels.empty() ? cv::Mat() : labels(window);
  BorderDistances distances(inner);
  const BandCutter cutter(image(window), distances, reach);
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    if (pass > 0) {
      distances = BorderDistances(inner);
    }
    if (!cutter.Cut(distances, inner_labels, &inner)) {
      break;
    }
  }
  return result;
}

}  // namespace octacut
