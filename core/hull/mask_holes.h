// Background that a mask's object encloses. For core/hull alone.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace octacut {

struct MaskHole {
  cv::Rect box;
  cv::Mat is_hole;  // CV_8UC1, 255 = yes, of the box
  size_t num_pixels = 0;
  // Pixel coordinates: what is at least half as far from the object as the
  // farthest pixel is, and the object two to five pixels from the hole.
  std::vector<Eigen::Vector2f> middle;
  std::vector<Eigen::Vector2f> ring;
};

// Those that hold a pixel farther than `margin` (pixels) from the object and
// are at most `max_share` of it. `mask` CV_8UC1; at least 128 counts as object.
std::vector<MaskHole> FindMaskHoles(const cv::Mat& mask,
                                    double margin,
                                    double max_share);

// The mask without the hole and the pixels at its border, which may be object
// in part.
void FillHole(const MaskHole& hole, cv::Mat* mask);

}  // namespace octacut
