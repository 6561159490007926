// Printed ArUco markers in a photograph (OpenCV behind it).
#pragma once

#include <array>
#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace octacut {

// OpenCV's predefined dictionaries that are in common use, such as 50 markers
// of four by four cells.
enum class MarkerDictionary {
  kFour50,
  kFour250,
  kFive250,
  kSix250,
  kSeven250,
  kOriginal,
  kAprilTag36h11,
};

struct DetectedMarker {
  int id = 0;
  // Pixels in COLMAP's convention: the centre of the first pixel is (0.5, 0.5).
  // Clockwise, from the marker's own first corner.
  std::array<Eigen::Vector2d, 4> corners;
};

// The markers in an image of 8 bits, grey or BGR; corners to a fraction of a
// pixel. An id that is seen more than once is left out, since the two cannot be
// told apart.
std::vector<DetectedMarker> DetectMarkers(const cv::Mat& image,
                                          MarkerDictionary dictionary);

}  // namespace octacut
