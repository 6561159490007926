#include "colmap_io/images/undistorted_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "colmap_io/model/camera_projector.h"

namespace octacut {
namespace {

// Smallest and largest coordinate of an image's edge after undistortion.
struct EdgeRange {
  double min = std::numeric_limits<double>::max();
  double max = std::numeric_limits<double>::lowest();

  void Add(double value) {
    min = std::min(min, value);
    max = std::max(max, value);
  }
};

// Target pixels of the source's edge pixels, as COLMAP samples them.
struct Edges {
  EdgeRange left, right, top, bottom;
};

Edges UndistortEdges(const CameraProjector& projector,
                     const PinholeCamera& pinhole) {
  const auto undistorted = [&](double x, double y) {
    const auto ray = projector.CamFromImg({x, y});
    return ray ? pinhole.Project(*ray) : Eigen::Vector2d(x, y);
  };
  const double last_x = pinhole.width - 0.5;
  const double last_y = pinhole.height - 0.5;
  Edges edges;
  for (int y = 0; y < pinhole.height; ++y) {
    edges.left.Add(undistorted(0.5, y + 0.5).x());
    edges.right.Add(undistorted(last_x, y + 0.5).x());
  }
  for (int x = 0; x < pinhole.width; ++x) {
    edges.top.Add(undistorted(x + 0.5, 0.5).y());
    edges.bottom.Add(undistorted(x + 0.5, last_y).y());
  }
  return edges;
}

// The scale at which neither edge leaves blank pixels, within COLMAP's limits.
double ScaleWithoutBlankPixels(double center,
                               double size,
                               const EdgeRange& low,
                               const EdgeRange& high) {
  const double max_scale = std::max(
      center / (center - low.max), (size - 0.5 - center) / (high.min - center));
  return std::clamp(1 / max_scale, 0.2, 2.0);
}

}  // namespace

bool IsPinhole(const SparseCamera& camera) {
  if (IsUndistorted(camera)) {
    return true;
  }
  switch (camera.model_id) {
    case camera_model::kSimpleRadial:
    case camera_model::kRadial:
    case camera_model::kOpenCV:
    case camera_model::kFullOpenCV:
    case camera_model::kSimpleDivision:
    case camera_model::kDivision:
      break;
    default:
      return false;
  }
  const std::array<double, 12> extra =
      CameraProjector(camera).Intrinsics().extra;
  return std::all_of(extra.begin(), extra.end(), [](double coefficient) {
    return std::abs(coefficient) < 1e-8;
  });
}

PinholeCamera UndistortedCamera(const SparseCamera& camera) {
  const CameraProjector projector(camera);
  const CameraIntrinsics& intrinsics = projector.Intrinsics();
  PinholeCamera pinhole{int(camera.width),
                        int(camera.height),
                        intrinsics.fx,
                        intrinsics.fy,
                        intrinsics.cx,
                        intrinsics.cy};
  if (IsPinhole(camera)) {
    return pinhole;
  }
  const Edges edges = UndistortEdges(projector, pinhole);
  const double scale_x = ScaleWithoutBlankPixels(
      pinhole.cx, pinhole.width, edges.left, edges.right);
  const double scale_y = ScaleWithoutBlankPixels(
      pinhole.cy, pinhole.height, edges.top, edges.bottom);
  pinhole.width = int(std::max(1.0, scale_x * double(camera.width)));
  pinhole.height = int(std::max(1.0, scale_y * double(camera.height)));
  pinhole.cx *= pinhole.width / double(camera.width);
  pinhole.cy *= pinhole.height / double(camera.height);
  return pinhole;
}

}  // namespace octacut
