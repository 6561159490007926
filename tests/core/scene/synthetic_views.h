// Views of analytic objects for the tests of this folder.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace octacut::testing {

inline Rigid3d LookAt(const Eigen::Vector3d& center,
                      const Eigen::Vector3d& target) {
  const Eigen::Vector3d z = (target - center).normalized();
  const Eigen::Vector3d up = std::abs(z.z()) < 0.9 ? Eigen::Vector3d::UnitZ()
                                                   : Eigen::Vector3d::UnitX();
  const Eigen::Vector3d x = z.cross(up).normalized();
  Rigid3d cam_from_world;
  cam_from_world.rotation.row(0) = x;
  cam_from_world.rotation.row(1) = z.cross(x);
  cam_from_world.rotation.row(2) = z;
  cam_from_world.translation = -(cam_from_world.rotation * center);
  return cam_from_world;
}

// A 320x240 view without image whose mask is 255 where hits(origin, direction)
// says that the ray meets the object.
using HitTest = std::function<bool(const Eigen::Vector3d& origin,
                                   const Eigen::Vector3d& direction)>;
inline View RenderView(const Eigen::Vector3d& center,
                       const Eigen::Vector3d& target,
                       double focal,
                       const HitTest& hits) {
  View view;
  view.name = "synthetic";
  view.camera = {320, 240, focal, focal, 160, 120};
  view.cam_from_world = LookAt(center, target);
  view.mask = cv::Mat(240, 320, CV_8UC1);
  const Eigen::Matrix3d world_from_cam =
      view.cam_from_world.rotation.transpose();
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      const Eigen::Vector3d direction =
          world_from_cam * view.camera.Unproject({x + 0.5, y + 0.5});
      view.mask.at<uint8_t>(y, x) = hits(center, direction) ? 255 : 0;
    }
  }
  return view;
}

inline HitTest Sphere(const Eigen::Vector3d& middle, double radius) {
  return [=](const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d d = direction.normalized();
    const Eigen::Vector3d to = middle - origin;
    return to.dot(d) > 0 && to.cross(d).norm() <= radius;
  };
}

inline HitTest Box(const Eigen::AlignedBox3d& box) {
  return [=](const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
    double t0 = 0;
    double t1 = 1e300;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (box.min()[axis] - origin[axis]) / direction[axis];
      const double b = (box.max()[axis] - origin[axis]) / direction[axis];
      t0 = std::max(t0, std::min(a, b));
      t1 = std::min(t1, std::max(a, b));
    }
    return t0 <= t1;
  };
}

// Centres on a sphere about `middle`, in two rings at +-25 degrees and one at
// the poles.
inline std::vector<Eigen::Vector3d> AllAround(const Eigen::Vector3d& middle,
                                              double distance) {
  std::vector<Eigen::Vector3d> centers;
  for (int i = 0; i < 24; ++i) {
    const double azimuth = 2 * M_PI * i / 24;
    const double elevation = (i % 2 ? 25 : -25) * M_PI / 180;
    centers.push_back(
        middle +
        distance * Eigen::Vector3d(std::cos(azimuth) * std::cos(elevation),
                                   std::sin(azimuth) * std::cos(elevation),
                                   std::sin(elevation)));
  }
  for (double s : {-1.0, 1.0}) {
    centers.push_back(middle + distance * Eigen::Vector3d(0, 0.05, s));
    centers.push_back(middle + distance * Eigen::Vector3d(0.7, 0, 0.7 * s));
  }
  return centers;
}

inline std::vector<View> RenderAllAround(const Eigen::Vector3d& middle,
                                         double distance,
                                         double focal,
                                         const HitTest& hits) {
  std::vector<View> views;
  for (const Eigen::Vector3d& center : AllAround(middle, distance)) {
    views.push_back(RenderView(center, middle, focal, hits));
  }
  return views;
}

}  // namespace octacut::testing
