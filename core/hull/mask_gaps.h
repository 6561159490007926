// Background of a mask where one may ask whether it is object: what the object
// encloses, and narrow bays of its border. For core/hull alone.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace octacut {

// The largest gap in units of the object's area. Larger gaps are hardly ever
// mistakes.
inline constexpr double kMaxGapShare = 0.05;

struct MaskGap {
  bool is_enclosed = false;  // else a bay
  cv::Rect box;
  cv::Mat is_gap;  // CV_8UC1, 255 = yes, of the box
  size_t num_pixels = 0;
  // Pixel coordinates: what is at least half as far from the gap's border as
  // its farthest pixel is, and the object two to five pixels from the gap.
  std::vector<Eigen::Vector2f> middle;
  std::vector<Eigen::Vector2f> ring;
};

// `mask` CV_8UC1. Enclosed gaps hold a pixel farther than `margin` (pixels)
// from the object and are at most a twentieth of it. A bay is what is left when
// a disc rolls around the object, of 6 % of the side of a square as large as
// the object; its middle is 2 % of that and twice `margin` from its border.
std::vector<MaskGap> FindMaskGaps(const cv::Mat& mask, double margin);

// Makes object of the gap and of the pixels at its border that are object in
// part.
void FillGap(const MaskGap& gap, cv::Mat* mask);

}  // namespace octacut
