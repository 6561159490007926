// Cameras of the core: pinhole, undistorted. COLMAP's conventions: x right,
// y down, z forward; the image's top-left corner is pixel coordinate (0, 0),
// the centre of the first pixel (0.5, 0.5).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>

namespace octacut {

struct PinholeCamera {
  int width = 0;   // pixels
  int height = 0;  // pixels
  double fx = 0;   // pixels
  double fy = 0;
  double cx = 0;
  double cy = 0;

  // Pixel coordinates of a point in the camera's frame; its z must be > 0.
  Eigen::Vector2d Project(const Eigen::Vector3d& point_in_cam) const {
    return {fx * point_in_cam.x() / point_in_cam.z() + cx,
            fy * point_in_cam.y() / point_in_cam.z() + cy};
  }
  // None for a point that is not before the camera, or out of the frame.
  std::optional<Eigen::Vector2d> ProjectIntoFrame(
      const Eigen::Vector3d& point_in_cam) const {
    if (!(point_in_cam.z() > 0)) {
      return std::nullopt;
    }
    const Eigen::Vector2d pixel = Project(point_in_cam);
    const bool is_in_frame = pixel.x() >= 0 && pixel.y() >= 0 &&
                             pixel.x() < width && pixel.y() < height;
    return is_in_frame ? std::optional(pixel) : std::nullopt;
  }
  // Direction in the camera's frame with z = 1.
  Eigen::Vector3d Unproject(const Eigen::Vector2d& pixel) const {
    return {(pixel.x() - cx) / fx, (pixel.y() - cy) / fy, 1.0};
  }
};

// b_from_a: x_b = rotation * x_a + translation.
struct Rigid3d {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator*(const Eigen::Vector3d& x) const {
    return rotation * x + translation;
  }
  Rigid3d Inverse() const {
    return {rotation.transpose(), -(rotation.transpose() * translation)};
  }
};

}  // namespace octacut
