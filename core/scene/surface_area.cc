#include "core/scene/surface_area.h"

#include <opencv2/core.hpp>

namespace octacut {
namespace {

int CountObjectPixels(const View& view) {
  cv::Mat is_object = view.mask >= kObjectThreshold;
  if (!view.unknown.empty()) {
    is_object.setTo(0, view.unknown);
  }
  return cv::countNonZero(is_object);
}

}  // namespace

double EstimateSurfaceArea(const std::vector<View>& views,
                           const BoundingCube& cube) {
  double sum = 0;
  int num_views = 0;
  for (const View& view : views) {
    if (view.mask.empty()) {
      continue;
    }
    const double depth = (view.cam_from_world * cube.Center()).z() / cube.edge;
    sum += CountObjectPixels(view) * depth * depth /
           (view.camera.fx * view.camera.fy);
    ++num_views;
  }
  return num_views > 0 ? 4 * sum / num_views : 0;
}

}  // namespace octacut
