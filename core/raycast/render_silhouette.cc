#include "core/raycast/render_silhouette.h"

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "core/base/parallel_pixels.h"

namespace octacut {
namespace {

constexpr int kSamples = 4;  // along a side of a pixel at the outline

// Whether rays through places of a picture hit the mesh.
class PixelHits {
 public:
  PixelHits(const RayScene& rays,
            const PixelRay& ray_of,
            const Rigid3d& cam_from_world)
      : rays_(rays),
        ray_of_(ray_of),
        world_from_cam_(cam_from_world.Inverse()) {}

  bool IsHit(double x, double y) const {
    const std::optional<Eigen::Vector3d> ray = ray_of_({x, y});
    return ray && rays_.IsOccluded(world_from_cam_.translation,
                                   world_from_cam_.rotation * *ray,
                                   0,
                                   std::numeric_limits<double>::infinity());
  }

  uint8_t Coverage(int x, int y) const {
    int num_hits = 0;
    for (int row = 0; row < kSamples; ++row) {
      for (int column = 0; column < kSamples; ++column) {
        num_hits +=
            IsHit(x + (column + 0.5) / kSamples, y + (row + 0.5) / kSamples);
      }
    }
    return uint8_t(std::lround(255.0 * num_hits / (kSamples * kSamples)));
  }

 private:
  const RayScene& rays_;
  const PixelRay& ray_of_;
  const Rigid3d world_from_cam_;
};

// `is_hit` is 255 for pixels whose centre shows the mesh.
cv::Mat SampleOutline(const PixelHits& hits,
                      cv::Mat is_hit,
                      const Context& context) {
  cv::Mat most;
  cv::Mat least;
  cv::dilate(is_hit, most, cv::Mat::ones(3, 3, CV_8U));
  cv::erode(is_hit, least, cv::Mat::ones(3, 3, CV_8U));
  ParallelPixels(context, is_hit.cols, is_hit.rows, [&](int x, int y) {
    if (most.at<uint8_t>(y, x) != least.at<uint8_t>(y, x)) {
      is_hit.at<uint8_t>(y, x) = hits.Coverage(x, y);
    }
  });
  return is_hit;
}

}  // namespace

cv::Mat RenderSilhouette(const RayScene& rays,
                         const cv::Size& size,
                         const PixelRay& ray_of,
                         const Rigid3d& cam_from_world,
                         const Context& context) {
  const PixelHits hits(rays, ray_of, cam_from_world);
  cv::Mat is_hit(size, CV_8UC1);
  ParallelPixels(context, size.width, size.height, [&](int x, int y) {
    is_hit.at<uint8_t>(y, x) = hits.IsHit(x + 0.5, y + 0.5) ? 255 : 0;
  });
  return SampleOutline(hits, is_hit, context);
}

cv::Mat RenderSilhouette(const RayScene& rays,
                         const PinholeCamera& camera,
                         const Rigid3d& cam_from_world,
                         const cv::Mat& depth,
                         const Context& context) {
  const PixelRay ray_of = [&](const Eigen::Vector2d& pixel) {
    return std::optional<Eigen::Vector3d>(camera.Unproject(pixel));
  };
  return SampleOutline(
      PixelHits(rays, ray_of, cam_from_world), depth > 0, context);
}

}  // namespace octacut
