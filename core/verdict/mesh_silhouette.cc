#include "core/verdict/mesh_silhouette.h"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <limits>

namespace octacut {
namespace {

constexpr int kBlock = 2;  // pixels
// Pixels from the border of the silhouette within which each has its own ray:
// those are the ones that are judged by fractions of a pixel.
constexpr float kNearBorder = 6;

}  // namespace

cv::Mat RenderHits(const RayScene& rays, const PreparedView& view) {
  const ViewProjection& projection = view.projection;
  const Eigen::Matrix3d unproject = projection.linear.cast<double>().inverse();
  const Eigen::Vector3d center = projection.center.cast<double>();
  const auto is_hit = [&](int x, int y) {
    return rays.IsOccluded(center,
                           unproject * Eigen::Vector3d(x + 0.5, y + 0.5, 1),
                           0,
                           std::numeric_limits<double>::infinity());
  };
  cv::Mat silhouette(projection.height, projection.width, CV_8UC1);
  for (int y = 0; y < silhouette.rows; y += kBlock) {
    const int y_end = std::min(y + kBlock, silhouette.rows);
    for (int x = 0; x < silhouette.cols; x += kBlock) {
      const int x_end = std::min(x + kBlock, silhouette.cols);
      const bool is_far = std::abs(view.silhouette.SignedDistance(
                              float(x) + 1, float(y) + 1)) > kNearBorder;
      const bool first = is_hit(x, y);
      for (int v = y; v < y_end; ++v) {
        for (int u = x; u < x_end; ++u) {
          const bool is_first = u == x && v == y;
          silhouette.at<uint8_t>(v, u) =
              (is_far || is_first ? first : is_hit(u, v)) ? 255 : 0;
        }
      }
    }
  }
  return silhouette;
}

}  // namespace octacut
