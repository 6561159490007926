#include "core/raycast/render_coverage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/check_option.h"
#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kCoverageRowsAtOnce = 8;

// Whether a neighbour of the pixel is hit where it is not, or the reverse.
bool IsAtOutline(const cv::Mat& depth, int x, int y) {
  const bool is_hit = depth.at<float>(y, x) > 0;
  for (int v = std::max(0, y - 1); v <= std::min(depth.rows - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(depth.cols - 1, x + 1);
         ++u) {
      if ((depth.at<float>(v, u) > 0) != is_hit) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

cv::Mat RenderCoverage(const RayScene& rays,
                       const PinholeCamera& camera,
                       const Rigid3d& cam_from_world,
                       const cv::Mat& depth,
                       const Context& context,
                       int samples) {
  CheckOption(samples >= 1, "samples", samples, "must be positive");
  const Rigid3d world_from_cam = cam_from_world.Inverse();
  const auto sampled = [&](int x, int y) {
    int num_hits = 0;
    for (int k = 0; k < samples * samples; ++k) {
      const int column = k % samples;
      const int row = k / samples;
      const Eigen::Vector3d ray =
          world_from_cam.rotation *
          camera.Unproject(
              {x + (column + 0.5) / samples, y + (row + 0.5) / samples});
      num_hits += rays.IsOccluded(world_from_cam.translation,
                                  ray,
                                  0,
                                  std::numeric_limits<double>::infinity());
    }
    return static_cast<uint8_t>(
        std::lround(255.0 * num_hits / (samples * samples)));
  };
  cv::Mat coverage(camera.height, camera.width, CV_8UC1);
  ParallelFor(context,
              static_cast<size_t>(camera.height),
              kCoverageRowsAtOnce,
              [&](size_t begin, size_t end) {
                for (int y = int(begin); y < int(end); ++y) {
                  for (int x = 0; x < camera.width; ++x) {
                    coverage.at<uint8_t>(y, x) =
                        IsAtOutline(depth, x, y)    ? sampled(x, y)
                        : depth.at<float>(y, x) > 0 ? 255
                                                    : 0;
                  }
                }
              });
  return coverage;
}

}  // namespace octacut
