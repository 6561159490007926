// Where the cameras of a synthetic scene stand.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/scene/camera.h"

namespace octacut {

// A camera with one coefficient of radial distortion, as COLMAP's
// SIMPLE_RADIAL has it: (u, v) -> (1 + k1 (u^2 + v^2)) (u, v) before the
// focal length. With k1 = 0 it is `camera` itself.
struct Lens {
  PinholeCamera camera;
  double k1 = 0;

  Eigen::Vector2d Project(const Eigen::Vector3d& point_in_cam) const;
  // Direction in the camera's frame with z = 1.
  Eigen::Vector3d Unproject(const Eigen::Vector2d& pixel) const;
};

enum class RigKind {
  kSphere,     // a spiral, even in elevation: hollows open upwards
  kRings,      // four rings from min_elevation to max_elevation
  kTurntable,  // one ring at min_elevation: the camera stands still, and so
               // does a room in which the object turns
};

struct RigOptions {
  RigKind kind = RigKind::kSphere;
  int num_views = 36;
  // Degrees above the object's horizon.
  double min_elevation = -35;
  double max_elevation = 82;
  int width = 1024;  // pixels
  int height = 768;
  // In units of the larger side of the image.
  double focal_length = 1.2;
  // Diameter of the object's bounding sphere in the image, in units of the
  // smaller side.
  double fill = 0.95;
  // Every second camera stands so many times as far from the object.
  double far_factor = 1;
  double k1 = 0;

  void Check() const;  // throws OptionError
};

Lens MakeLens(const RigOptions& options);

// Poses (cam_from_world) of num_views cameras that look at `center`, the
// image's vertical along z, at the distance where a sphere of `radius` fills
// the image as the options say.
std::vector<Rigid3d> MakeRig(const RigOptions& options,
                             const Eigen::Vector3d& center,
                             double radius);

// A camera at `eye` that looks at `target` with `up` upward in the image.
Rigid3d LookAt(const Eigen::Vector3d& eye,
               const Eigen::Vector3d& target,
               const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ());

}  // namespace octacut
