// The outline of a silhouette below the size of a pixel, and distances to it.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace octacut {

// Pixel coordinates: the centre of the first pixel at (0.5, 0.5).
struct OutlineSegment {
  Eigen::Vector2d begin;
  Eigen::Vector2d end;
};

class Outline {
 public:
  // Where coverage (CV_8UC1, 0 .. 255), linear between the pixels' centres,
  // is half: marching squares. The border of the frame is no outline.
  explicit Outline(const cv::Mat& coverage);

  const std::vector<OutlineSegment>& Segments() const { return segments_; }

  // From a point of the frame to the nearest segment, pixels; infinite when
  // there is none.
  double Distance(const Eigen::Vector2d& point) const;

 private:
  void AddCell(const cv::Mat& coverage, int x, int y);

  // Cells lie between four pixels' centres; that of cell (0, 0) begins at
  // (0.5, 0.5).
  int num_columns_;
  int num_rows_;
  std::vector<OutlineSegment> segments_;  // cell after cell
  std::vector<uint32_t> first_;           // of each cell, and one past the last
  cv::Mat
      to_nearest_;  // CV_32F, from each cell to the nearest one that has any
};

}  // namespace octacut
