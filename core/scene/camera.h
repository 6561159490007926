// Cameras of the core: pinhole, undistorted. COLMAP's conventions: x right,
// y down, z forward; the image's top-left corner is pixel coordinate (0, 0),
// the centre of the first pixel (0.5, 0.5).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

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
