#include "core/segment/still_object.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/segment/colour_contrast.h"
#include "core/segment/label_cut.h"
#include "core/segment/labels.h"
#include "core/segment/pixel_features.h"
#include "core/segment/view_confidence.h"

namespace octacut {
namespace {

// Less of the frame than this is left to the cuts in the photographs.
constexpr double kLeastOfFrame = 5e-4;
constexpr int kRounds = 4;
constexpr size_t kStillSamples = 6000;
constexpr float kStillSmoothness = 8;
constexpr double kLeastContrast = 0.6;
// Log odds below which colours tell nothing.
constexpr float kClear = 1;
// Part of the frame's width at its sides that is background.
constexpr double kSide = 0.02;

// What lies between the outermost points that turn, in each row.
cv::Mat BetweenTurning(const cv::Mat& turning) {
  cv::Mat between = cv::Mat::zeros(turning.size(), CV_8U);
  for (int y = 0; y < turning.rows; ++y) {
    const uint8_t* const row = turning.ptr<uint8_t>(y);
    int first = 0;
    while (first < turning.cols && row[first] == 0) {
      ++first;
    }
    int last = turning.cols - 1;
    while (last > first && row[last] == 0) {
      --last;
    }
    if (first < last) {
      between.row(y).colRange(first, last + 1).setTo(255);
    }
  }
  return between;
}

cv::Mat ToBgr(const cv::Mat& lab) {
  cv::Mat bytes;
  lab.convertTo(bytes, CV_8UC3);
  cv::Mat image;
  cv::cvtColor(bytes, image, cv::COLOR_Lab2BGR);
  return image;
}

// What can be nothing but background: the sides of the frame, and what is
// beside or below all that turns.
cv::Mat SureBackground(const cv::Mat& turning) {
  const cv::Rect box = cv::boundingRect(turning);
  cv::Mat sure(turning.size(), CV_8U, cv::Scalar(255));
  const int side = int(std::ceil(kSide * turning.cols));
  const int left = std::max(side, box.x);
  const int right = std::min(turning.cols - side, box.x + box.width);
  if (left < right) {
    sure.colRange(left, right).rowRange(0, box.y + box.height).setTo(0);
  }
  return sure;
}

}  // namespace

StillObject FindStillObject(const StillBackground& background,
                            const cv::Mat& varies,
                            const cv::Mat& turning) {
  StillObject result;
  result.mask = cv::Mat::zeros(turning.size(), CV_8U);
  cv::Mat solid;
  cv::morphologyEx(turning,
                   solid,
                   cv::MORPH_OPEN,
                   cv::Mat::ones(kStillWindow, kStillWindow, CV_8U));
  if (cv::countNonZero(solid) == 0) {
    return result;
  }
  cv::Mat seeds =
      BetweenTurning(solid) & ~turning & ((background.support > 0.9f) | varies);
  cv::erode(seeds, seeds, cv::Mat::ones(kStillWindow, kStillWindow, CV_8U));
  const double frame = double(turning.total());
  if (cv::countNonZero(seeds) < kLeastOfFrame * frame) {
    return result;
  }
  const cv::Mat sure = SureBackground(solid) & ~turning;
  const cv::Mat image = ToBgr(background.color);
  const cv::Mat features = PixelFeatures(image);
  const cv::Mat all(turning.size(), CV_8U, cv::Scalar(255));
  const std::vector<PixelFeature> surroundings =
      SampleFeatures(features, sure, kStillSamples);
  cv::Mat object = seeds.clone();
  cv::Mat log_odds;
  for (int round = 0; round < kRounds; ++round) {
    log_odds = ColourContrast(SampleFeatures(features, object, kStillSamples),
                              surroundings)
                   .LogOdds(features, all);
    cv::Mat labels(turning.size(), CV_8U, cv::Scalar(kNoLabel));
    labels.setTo(kSurroundingsLabel, sure);
    labels.setTo(kObjectLabel, turning);
    labels.setTo(kObjectLabel, seeds);
    CutLabels(image, log_odds, kStillSmoothness, &labels);
    object = (labels == kObjectLabel) & ~turning;
  }
  // What is told clearly: the seeds themselves must look different from the
  // background, and so must the border that is not with what turns.
  cv::Mat clear = log_odds.clone();
  clear.setTo(0, cv::abs(log_odds) < kClear);
  clear.setTo(-ColourContrast::kMostOdds, turning);
  const double told =
      double(cv::countNonZero((clear > 0) & seeds)) / cv::countNonZero(seeds);
  const double contrast = std::min(told, BorderContrast(object, clear));
  if (contrast < kLeastContrast) {
    result.doubt = fmt::format(
        "a part in front of the plate looks the same in all photographs, and "
        "along {:.0f} % of its border as the background does; photographs of "
        "the empty set (background_path) can tell",
        100 * (1 - contrast));
  }
  result.mask = object;
  result.sure = seeds;
  result.sure_background = sure;
  return result;
}

}  // namespace octacut
