#include "core/raycast/render_silhouette.h"

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kSilhouetteRows = 8;
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

// Sets each pixel of `pixels` to what `value` has for it, or leaves it.
template <typename Value>
void SetPixels(const Context& context, const Value& value, cv::Mat* pixels) {
  ParallelFor(context,
              size_t(pixels->rows),
              kSilhouetteRows,
              [&](size_t begin, size_t end) {
                for (int y = int(begin); y < int(end); ++y) {
                  for (int x = 0; x < pixels->cols; ++x) {
                    value(x, y, &pixels->at<uint8_t>(y, x));
                  }
                }
              });
}

// `is_hit` is 255 for pixels whose centre shows the mesh.
cv::Mat SampleOutline(const PixelHits& hits,
                      cv::Mat is_hit,
                      const Context& context) {
  cv::Mat most;
  cv::Mat least;
  cv::dilate(is_hit, most, cv::Mat::ones(3, 3, CV_8U));
  cv::erode(is_hit, least, cv::Mat::ones(3, 3, CV_8U));
  SetPixels(
      context,
      [&](int x, int y, uint8_t* coverage) {
        if (most.at<uint8_t>(y, x) != least.at<uint8_t>(y, x)) {
          *coverage = hits.Coverage(x, y);
        }
      },
      &is_hit);
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
  SetPixels(
      context,
      [&](int x, int y, uint8_t* pixel) {
        *pixel = hits.IsHit(x + 0.5, y + 0.5) ? 255 : 0;
      },
      &is_hit);
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
