#include "colmap_io/images/view_window.h"

#include <algorithm>
#include <cmath>

#include "colmap_io/model/camera_projector.h"
#include "core/base/check_option.h"

namespace octacut {
namespace {

constexpr int kEdgeSamples = 256;  // along each edge of the frame

// Bounding box of the tangents of the region's box; empty when it reaches the
// camera's plane, since it may be anywhere then.
std::optional<Eigen::AlignedBox2d> TangentsOfBox(
    const Eigen::AlignedBox3d& box, const Rigid3d& cam_from_world) {
  Eigen::AlignedBox2d tangents;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d point =
        cam_from_world * box.corner(Eigen::AlignedBox3d::CornerType(corner));
    if (point.z() <= 1e-3 * box.diagonal().norm()) {
      return {};
    }
    tangents.extend(
        Eigen::Vector2d(point.x() / point.z(), point.y() / point.z()));
  }
  return tangents;
}

// Depth range of the box along the viewing axis.
Eigen::AlignedBox1d DepthsOfBox(const Eigen::AlignedBox3d& box,
                                const Rigid3d& cam_from_world) {
  Eigen::AlignedBox1d depths;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d point =
        cam_from_world * box.corner(Eigen::AlignedBox3d::CornerType(corner));
    depths.extend(Eigen::Matrix<double, 1, 1>(point.z()));
  }
  return depths;
}

// First pixel and size of a window along one axis.
struct Span {
  int first;
  int size;
};

// `low` and `high` are what is wanted, `frame_low` and `frame_high` what is
// there, in pixels; whole pixels within the frame.
Span WindowSpan(
    double low, double high, double frame_low, double frame_high, int margin) {
  constexpr double kRounding = 1e-6;
  const int first =
      int(std::max(std::floor(low) - margin, std::ceil(frame_low - kRounding)));
  const int last = int(
      std::min(std::ceil(high) + margin, std::floor(frame_high + kRounding)));
  return {first, std::max(0, last - first)};
}

}  // namespace

void WindowOptions::Check() const {
  CheckOption(pixels_per_voxel > 0 && pixels_per_voxel <= 100,
              "pixels_per_voxel",
              pixels_per_voxel,
              "must be in (0, 100]");
  CheckOption(min_reduction >= 1 && min_reduction <= 10,
              "min_reduction",
              min_reduction,
              "must be in [1, 10]");
  CheckOption(
      margin >= 0 && margin <= 1000, "margin", margin, "must be in [0, 1000]");
}

Frame FrameOfCamera(const SparseCamera& camera) {
  const CameraProjector projector(camera);
  Frame frame;
  const auto add = [&](double x, double y) {
    const auto ray = projector.CamFromImg({x, y});
    if (!ray || !(ray->z() > 0)) {
      frame.complete = false;
      return;
    }
    const Eigen::Vector2d tangents(ray->x() / ray->z(), ray->y() / ray->z());
    if (!tangents.allFinite() || tangents.cwiseAbs().maxCoeff() > kMaxTangent) {
      frame.complete = false;
    } else {
      frame.tangents.extend(tangents);
    }
  };
  const double width = double(camera.width);
  const double height = double(camera.height);
  for (int i = 0; i <= kEdgeSamples; ++i) {
    const double t = double(i) / kEdgeSamples;
    add(t * width, 0);
    add(t * width, height);
    add(0, t * height);
    add(width, t * height);
  }
  if (!frame.complete) {
    const Eigen::Vector2d most = Eigen::Vector2d::Constant(kMaxTangent);
    frame.tangents = {-most, most};
  }
  return frame;
}

std::optional<PinholeCamera> PlanWindow(const SparseCamera& camera,
                                        const Frame& frame,
                                        const Rigid3d& cam_from_world,
                                        const Region& region,
                                        int target_level,
                                        const WindowOptions& options) {
  const Eigen::AlignedBox1d depths = DepthsOfBox(region.box, cam_from_world);
  const double farthest = depths.max()[0];
  if (farthest <= 0) {
    return {};  // all of it is behind the camera
  }
  const CameraIntrinsics intrinsics = CameraProjector(camera).Intrinsics();
  // A voxel at depth z is fx * voxel / z pixels wide.
  const double needed =
      options.pixels_per_voxel * farthest / region.cube.VoxelSize(target_level);
  double scale = needed / std::min(intrinsics.fx, intrinsics.fy);
  if (scale * options.min_reduction > 1) {
    scale = 1;
  }
  PinholeCamera window;
  window.fx = scale * intrinsics.fx;
  window.fy = scale * intrinsics.fy;
  const Eigen::Array2d focal(window.fx, window.fy);
  const Eigen::Array2d principal(scale * intrinsics.cx, scale * intrinsics.cy);
  const Eigen::AlignedBox2d wanted =
      TangentsOfBox(region.box, cam_from_world).value_or(frame.tangents);
  const auto pixels = [&](const Eigen::Vector2d& tangents) -> Eigen::Array2d {
    return tangents.array() * focal + principal;
  };
  const Eigen::Array2d low = pixels(wanted.min());
  const Eigen::Array2d high = pixels(wanted.max());
  const Eigen::Array2d frame_low = pixels(frame.tangents.min());
  const Eigen::Array2d frame_high = pixels(frame.tangents.max());
  if ((low > frame_high).any() || (high < frame_low).any()) {
    return {};
  }
  const Span columns = WindowSpan(
      low.x(), high.x(), frame_low.x(), frame_high.x(), options.margin);
  const Span rows = WindowSpan(
      low.y(), high.y(), frame_low.y(), frame_high.y(), options.margin);
  // Nothing can be interpolated in a row of pixels.
  if (columns.size < 2 || rows.size < 2) {
    return {};
  }
  window.width = columns.size;
  window.height = rows.size;
  window.cx = principal.x() - columns.first;
  window.cy = principal.y() - rows.first;
  return window;
}

size_t SceneBytes(const std::vector<PinholeCamera>& cameras) {
  size_t bytes = 0;
  for (const PinholeCamera& camera : cameras) {
    bytes += 4 * size_t(camera.width) * size_t(camera.height);  // BGR and mask
  }
  return bytes;
}

}  // namespace octacut
