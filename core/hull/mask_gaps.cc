#include "core/hull/mask_gaps.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/scene/pixel_distance.h"
#include "core/scene/scene.h"

namespace octacut {
namespace {

// The radius of the disc that rolls around the object, and the depth of bays,
// in units of the side of a square as large as the object. Objects have shallow
// bays of their own that one view alone sees.
constexpr double kDiscRadius = 0.06;
constexpr double kMinBayDepth = 0.02;
constexpr float kRingBegin = 2;
constexpr float kRingEnd = 5;
constexpr int kWindowMargin = 6;

// Within the frame.
cv::Rect Grown(const cv::Rect& box, int margin, const cv::Size& frame) {
  return cv::Rect(box.x - margin,
                  box.y - margin,
                  box.width + 2 * margin,
                  box.height + 2 * margin) &
         cv::Rect(cv::Point(), frame);
}

// Where no disc that is free of the object reaches; beyond the frame all is as
// at its border.
cv::Mat Closed(const cv::Mat& object, double radius) {
  const int margin = int(std::ceil(radius)) + 1;
  cv::Mat wide;
  cv::copyMakeBorder(
      object, wide, margin, margin, margin, margin, cv::BORDER_REPLICATE);
  const cv::Mat near = PixelsNear(wide, radius);
  const cv::Mat closed = DistancesToZero(near) > radius;
  return closed(cv::Rect(cv::Point(margin, margin), object.size()));
}

// Pixels of `window` where `where` is not 0.
std::vector<Eigen::Vector2f> PixelCenters(const cv::Mat& where,
                                          const cv::Rect& window) {
  std::vector<cv::Point> pixels;
  cv::findNonZero(where, pixels);
  std::vector<Eigen::Vector2f> centers;
  centers.reserve(pixels.size());
  for (const cv::Point& pixel : pixels) {
    centers.emplace_back(float(window.x + pixel.x) + 0.5f,
                         float(window.y + pixel.y) + 0.5f);
  }
  return centers;
}

// Connected parts of what is not 0.
struct Parts {
  cv::Mat labels;  // CV_32S; 0: none
  cv::Mat stats;
  int count = 0;  // labels are 1 .. count - 1

  explicit Parts(const cv::Mat& image) {
    cv::Mat centroids;
    count =
        cv::connectedComponentsWithStats(image, labels, stats, centroids, 4);
  }
  cv::Rect Box(int label) const {
    const int* row = stats.ptr<int>(label);
    return {row[cv::CC_STAT_LEFT],
            row[cv::CC_STAT_TOP],
            row[cv::CC_STAT_WIDTH],
            row[cv::CC_STAT_HEIGHT]};
  }
  int Area(int label) const { return stats.ptr<int>(label)[cv::CC_STAT_AREA]; }
};

// Appends the part unless it is less deep than `margin`.
void AddGap(const Parts& parts,
            int label,
            const cv::Mat& object,
            bool is_enclosed,
            double margin,
            std::vector<MaskGap>* gaps) {
  MaskGap gap;
  gap.is_enclosed = is_enclosed;
  gap.box = parts.Box(label);
  gap.num_pixels = size_t(parts.Area(label));
  const cv::Rect window = Grown(gap.box, kWindowMargin, object.size());
  const cv::Mat is_gap = parts.labels(window) == label;
  const cv::Mat depths = DistancesToZero(is_gap);
  double deepest;
  cv::minMaxLoc(depths, nullptr, &deepest);
  if (deepest <= margin) {
    return;
  }
  const cv::Mat beside = DistancesToZero(~is_gap);
  gap.is_gap = cv::Mat(parts.labels(gap.box) == label);
  gap.middle = PixelCenters(depths >= deepest / 2, window);
  gap.ring = PixelCenters(
      (beside >= kRingBegin) & (beside <= kRingEnd) & object(window), window);
  gaps->push_back(std::move(gap));
}

}  // namespace

std::vector<MaskGap> FindMaskGaps(const cv::Mat& mask, double margin) {
  const cv::Mat object = mask >= kObjectThreshold;
  const double area = cv::countNonZero(object);
  const double side = std::sqrt(area);
  std::vector<MaskGap> gaps;
  const Parts background(~object);
  cv::Mat outside = ~object;
  for (int label = 1; label < background.count; ++label) {
    const cv::Rect box = background.Box(label);
    if (!TouchesFrame(box, mask.size()) &&
        background.Area(label) <= kMaxGapShare * area) {
      AddGap(background, label, object, true, margin, &gaps);
      outside(box).setTo(0, background.labels(box) == label);
    }
  }
  const Parts bays(Closed(object, kDiscRadius * side) & outside);
  const double min_depth = std::max(2 * margin, kMinBayDepth * side);
  for (int label = 1; label < bays.count; ++label) {
    if (bays.Area(label) <= kMaxGapShare * area) {
      AddGap(bays, label, object, false, min_depth, &gaps);
    }
  }
  return gaps;
}

void FillGap(const MaskGap& gap, cv::Mat* mask) {
  const cv::Rect around = Grown(gap.box, 1, mask->size());
  cv::Mat filled = cv::Mat::zeros(around.size(), CV_8UC1);
  gap.is_gap.copyTo(filled(gap.box - around.tl()));
  cv::Mat beside;
  cv::dilate(filled, beside, cv::Mat::ones(3, 3, CV_8UC1));
  cv::Mat pixels = (*mask)(around);
  pixels.setTo(255, filled | (beside & (pixels >= kObjectThreshold)));
}

}  // namespace octacut
