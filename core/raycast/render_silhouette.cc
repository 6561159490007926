#include "core/raycast/render_silhouette.h"

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kSilhouetteRows = 8;
constexpr int kSamples = 4;  // along a side of a pixel at the outline

}  // namespace

cv::Mat RenderSilhouette(const RayScene& rays,
                         const cv::Size& size,
                         const PixelRay& ray_of,
                         const Rigid3d& cam_from_world,
                         const Context& context) {
  const Rigid3d world_from_cam = cam_from_world.Inverse();
  const auto is_hit = [&](double x, double y) {
    const std::optional<Eigen::Vector3d> ray = ray_of({x, y});
    return ray && rays.IsOccluded(world_from_cam.translation,
                                  world_from_cam.rotation * *ray,
                                  0,
                                  std::numeric_limits<double>::infinity());
  };
  cv::Mat coverage(size, CV_8UC1);
  const auto for_each_row = [&](const std::function<void(int)>& body) {
    ParallelFor(context,
                size_t(size.height),
                kSilhouetteRows,
                [&](size_t begin, size_t end) {
                  for (size_t y = begin; y < end; ++y) {
                    body(int(y));
                  }
                });
  };
  for_each_row([&](int y) {
    for (int x = 0; x < size.width; ++x) {
      coverage.at<uint8_t>(y, x) = is_hit(x + 0.5, y + 0.5) ? 255 : 0;
    }
  });
  cv::Mat most;
  cv::Mat least;
  cv::dilate(coverage, most, cv::Mat::ones(3, 3, CV_8U));
  cv::erode(coverage, least, cv::Mat::ones(3, 3, CV_8U));
  const cv::Mat outline = most != least;
  for_each_row([&](int y) {
    for (int x = 0; x < size.width; ++x) {
      if (outline.at<uint8_t>(y, x) == 0) {
        continue;
      }
      int num_hits = 0;
      for (int k = 0; k < kSamples * kSamples; ++k) {
        num_hits += is_hit(x + (k % kSamples + 0.5) / kSamples,
                           y + (k / kSamples + 0.5) / kSamples);
      }
      coverage.at<uint8_t>(y, x) =
          uint8_t(std::lround(255.0 * num_hits / (kSamples * kSamples)));
    }
  });
  return coverage;
}

}  // namespace octacut
