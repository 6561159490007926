#include "core/hull/mask_holes.h"

#include <opencv2/imgproc.hpp>

namespace octacut {
namespace {

constexpr double kObjectThreshold = 127;
constexpr float kRingBegin = 2;
constexpr float kRingEnd = 5;
constexpr int kWindowMargin = 6;

cv::Rect Grown(const cv::Rect& box, int margin, const cv::Size& size) {
  return cv::Rect(box.x - margin,
                  box.y - margin,
                  box.width + 2 * margin,
                  box.height + 2 * margin) &
         cv::Rect(cv::Point(), size);
}

// Background that touches the frame is not enclosed.
bool IsEnclosed(const cv::Rect& box, const cv::Size& size) {
  return box.x > 0 && box.y > 0 && box.x + box.width < size.width &&
         box.y + box.height < size.height;
}

// To the next pixel that is 0, of each pixel that is not.
cv::Mat Distances(const cv::Mat& image) {
  cv::Mat distances;
  cv::distanceTransform(
      image, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
  return distances;
}

// Pixels of `window` where `where` is not 0.
std::vector<Eigen::Vector2f> PixelCenters(const cv::Mat& where,
                                          const cv::Rect& window) {
  std::vector<cv::Point> pixels;
  cv::findNonZero(where, pixels);
  std::vector<Eigen::Vector2f> centers;
  for (const cv::Point& pixel : pixels) {
    centers.emplace_back(float(window.x + pixel.x) + 0.5f,
                         float(window.y + pixel.y) + 0.5f);
  }
  return centers;
}

}  // namespace

std::vector<MaskHole> FindMaskHoles(const cv::Mat& mask,
                                    double margin,
                                    double max_share) {
  const cv::Mat background = mask <= kObjectThreshold;
  cv::Mat labels, stats, centroids;
  const int count =
      cv::connectedComponentsWithStats(background, labels, stats, centroids, 4);
  const double max_pixels =
      max_share * (double(mask.total()) - double(cv::countNonZero(background)));
  std::vector<MaskHole> holes;
  for (int label = 1; label < count; ++label) {
    const int* of_label = stats.ptr<int>(label);
    MaskHole hole;
    hole.box = {of_label[cv::CC_STAT_LEFT],
                of_label[cv::CC_STAT_TOP],
                of_label[cv::CC_STAT_WIDTH],
                of_label[cv::CC_STAT_HEIGHT]};
    hole.num_pixels = size_t(of_label[cv::CC_STAT_AREA]);
    if (!IsEnclosed(hole.box, mask.size()) ||
        double(hole.num_pixels) > max_pixels) {
      continue;
    }
    const cv::Rect window = Grown(hole.box, kWindowMargin, mask.size());
    const cv::Mat is_hole = labels(window) == label;
    const cv::Mat depths = Distances(is_hole);
    double deepest;
    cv::minMaxLoc(depths, nullptr, &deepest);
    if (deepest <= margin) {
      continue;
    }
    const cv::Mat beside = Distances(~is_hole);
    hole.is_hole = cv::Mat(labels(hole.box) == label);
    hole.middle = PixelCenters(depths >= deepest / 2, window);
    hole.ring = PixelCenters(
        (beside >= kRingBegin) & (beside <= kRingEnd) & ~background(window),
        window);
    holes.push_back(std::move(hole));
  }
  return holes;
}

void FillHole(const MaskHole& hole, cv::Mat* mask) {
  // It is enclosed: a pixel more on all sides is within the frame.
  const cv::Rect around = Grown(hole.box, 1, mask->size());
  cv::Mat filled = cv::Mat::zeros(around.size(), CV_8UC1);
  hole.is_hole.copyTo(filled(hole.box - around.tl()));
  cv::dilate(filled, filled, cv::Mat::ones(3, 3, CV_8UC1));
  (*mask)(around).setTo(255, filled);
}

}  // namespace octacut
