#include "core/segment/view_confidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/base/median.h"
#include "core/segment/other_views.h"

namespace octacut {
namespace {

// Pixels at a border that say nothing: the other views know it to a voxel.
constexpr double kBorder = 2;
// Pixels from the border whose colours are looked at.
constexpr double kRing = 4;
constexpr double kLeastConfidence = 0.5;
// No view within so many standard deviations of the median is an exception.
constexpr double kUsualDeviations = 3;
// An exception agrees less than the median by this or more: from a side that
// few views look from, the others leave a fifth more than there is for a true
// silhouette.
constexpr double kLeastSpread = 0.25;
// An exception has lost this or more: silhouettes that are right have up to
// 0.07, since the others know the object to some voxels.
constexpr double kLeastLoss = 0.08;

cv::Mat DistanceToOther(const cv::Mat& mask) {
  cv::Mat distance;
  cv::distanceTransform(mask, distance, cv::DIST_L2, cv::DIST_MASK_5);
  return distance;
}

double Agreement(const cv::Mat& mask, const cv::Mat& others) {
  const cv::Mat allowed = others > 0;
  const cv::Mat counted =
      ((DistanceToOther(mask) > kBorder) | (DistanceToOther(~mask) > kBorder)) &
      ((DistanceToOther(allowed) > kBorder) |
       (DistanceToOther(~allowed) > kBorder));
  const int common = cv::countNonZero(mask & allowed & counted);
  const int either = cv::countNonZero((mask | allowed) & counted);
  return either == 0 ? 0 : double(common) / either;
}

double Lost(const cv::Mat& mask, const cv::Mat& shown) {
  cv::Mat lost = shown & ~mask;
  // What lies beyond the frame is not known to be lost.
  cv::copyMakeBorder(lost, lost, 1, 1, 1, 1, cv::BORDER_CONSTANT, 0);
  double radius = 0;
  cv::minMaxLoc(DistanceToOther(lost), nullptr, &radius);
  return radius / std::sqrt(std::max(1, cv::countNonZero(mask)));
}

}  // namespace

double BorderContrast(const cv::Mat& mask, const cv::Mat& log_odds) {
  const cv::Mat inside = DistanceToOther(mask);
  const cv::Mat outside = DistanceToOther(~mask);
  const cv::Mat inner = (inside > kBorder) & (inside <= kBorder + kRing);
  const cv::Mat outer = (outside > kBorder) & (outside <= kBorder + kRing);
  const auto share = [](const cv::Mat& right, const cv::Mat& ring) {
    const int all = cv::countNonZero(ring);
    return all == 0 ? 0.0 : double(cv::countNonZero(right & ring)) / all;
  };
  return std::min(share(log_odds > 0, inner), share(log_odds < 0, outer));
}

std::vector<ViewConfidence> JudgeViews(const Segmentation& segmentation,
                                       std::span<const cv::Mat> masks) {
  std::vector<ViewConfidence> result(masks.size());
  std::vector<double> agreements;
  std::vector<double> losses;
  for (size_t i = 0; i < masks.size(); ++i) {
    const SegmentedView& view = segmentation.views[i];
    ViewConfidence& judged = result[i];
    judged.agreement = Agreement(masks[i], view.others);
    judged.contrast = BorderContrast(masks[i], view.colours);
    judged.confidence = judged.agreement * judged.contrast;
    judged.lost = Lost(masks[i], ShownByOthers(view.others, masks.size() - 1));
    agreements.push_back(judged.agreement);
    losses.push_back(judged.lost);
  }
  const MedianSpread usual = SpreadAroundMedian(std::move(agreements));
  const double least =
      std::max(kLeastConfidence,
               usual.median -
                   std::max(kLeastSpread, kUsualDeviations * usual.deviation));
  const MedianSpread usual_loss = SpreadAroundMedian(std::move(losses));
  const double most_lost = std::max(
      kLeastLoss, usual_loss.median + kUsualDeviations * usual_loss.deviation);
  for (size_t i = 0; i < masks.size(); ++i) {
    ViewConfidence& judged = result[i];
    if (cv::countNonZero(masks[i]) == 0) {
      judged.doubt = "the object was not found in it";
    } else if (judged.contrast < kLeastConfidence) {
      judged.doubt = fmt::format(
          "object and surroundings look alike along {:.0f} % of the border",
          100 * (1 - judged.contrast));
    } else if (judged.agreement < least) {
      judged.doubt = fmt::format(
          "its silhouette agrees to {:.0f} % with those of the other views, "
          "where {:.0f} % are usual",
          100 * judged.agreement,
          100 * usual.median);
    } else if (judged.lost > most_lost) {
      judged.doubt =
          "its silhouette lacks a part of the object that the other views show";
    }
  }
  return result;
}

}  // namespace octacut
