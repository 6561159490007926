// A ball above a round plate that turns before a still background.
#pragma once

#include <Eigen/Geometry>
#include <limits>

#include "core/segment/labels.h"
#include "tests/core/segment/ring_scene.h"

namespace octacut::testing {

inline constexpr double kPlateHeight = -0.5;
inline constexpr double kPlateRadius = 0.6;

// Where the ray of a pixel meets the plane of the plate, its distance from the
// axis; infinity where it does not.
inline double RadiusOnPlate(const Pose& pose, int x, int y) {
  const Rigid3d world_from_cam = pose.cam_from_world.Inverse();
  const Eigen::Vector3d direction =
      world_from_cam.rotation * pose.camera.Unproject({x + 0.5, y + 0.5});
  const double depth =
      (kPlateHeight - world_from_cam.translation.z()) / direction.z();
  const Eigen::Vector3d point = world_from_cam.translation + depth * direction;
  return depth > 0 ? point.head<2>().norm()
                   : std::numeric_limits<double>::infinity();
}

inline RingScene MakePlateScene(int count) {
  RingScene scene = MakeRingScene(count, {{0, 0, 0}, 0.45});
  scene.input.floor =
      Eigen::Hyperplane<double, 3>(Eigen::Vector3d::UnitZ(), -kPlateHeight);
  for (size_t i = 0; i < scene.truth.size(); ++i) {
    UnsegmentedView& view = scene.input.views[i];
    view.is_turntable = true;
    view.labels.create(scene.truth[i].size(), CV_8U);
    view.labels.setTo(kSurroundingsLabel);
    view.labels.setTo(kNoLabel, scene.truth[i]);
    for (int y = 0; y < view.labels.rows; ++y) {
      for (int x = 0; x < view.labels.cols; ++x) {
        if (RadiusOnPlate(view.pose, x, y) < kPlateRadius) {
          view.labels.at<uint8_t>(y, x) = kNoLabel;
        }
      }
    }
  }
  return scene;
}

}  // namespace octacut::testing
