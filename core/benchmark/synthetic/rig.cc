#include "core/benchmark/synthetic/rig.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/check_option.h"
#include "core/benchmark/synthetic/angles.h"

namespace octacut {

Eigen::Vector2d Lens::Project(const Eigen::Vector3d& point_in_cam) const {
  const double u = point_in_cam.x() / point_in_cam.z();
  const double v = point_in_cam.y() / point_in_cam.z();
  const double factor = 1 + k1 * (u * u + v * v);
  return {camera.fx * factor * u + camera.cx,
          camera.fy * factor * v + camera.cy};
}

Eigen::Vector3d Lens::Unproject(const Eigen::Vector2d& pixel) const {
  Eigen::Vector3d ray = camera.Unproject(pixel);
  if (k1 != 0) {
    // Newton on r (1 + k1 r^2) = distorted radius.
    const double distorted = ray.head<2>().norm();
    double radius = distorted;
    for (int round = 0; round < 8; ++round) {
      const double error = radius * (1 + k1 * radius * radius) - distorted;
      radius -= error / (1 + 3 * k1 * radius * radius);
    }
    if (distorted > 0) {
      ray.head<2>() *= radius / distorted;
    }
  }
  return ray;
}

void RigOptions::Check() const {
  CheckOption(num_views >= 1, "rig.num_views", num_views, "must be positive");
  CheckOption(min_elevation >= -90 && min_elevation <= max_elevation,
              "rig.min_elevation",
              min_elevation,
              "must be in [-90, max_elevation]");
  CheckOption(max_elevation <= 90,
              "rig.max_elevation",
              max_elevation,
              "must be at most 90");
  CheckOption(width >= 8, "rig.width", width, "must be at least 8");
  CheckOption(height >= 8, "rig.height", height, "must be at least 8");
  CheckOption(focal_length > 0.2 && focal_length < 20,
              "rig.focal_length",
              focal_length,
              "must be in (0.2, 20)");
  CheckOption(fill > 0, "rig.fill", fill, "must be positive");
  CheckOption(far_factor >= 1 && far_factor <= 10,
              "rig.far_factor",
              far_factor,
              "must be in [1, 10]");
  // Further than that the distortion may fold the image's corners over.
  CheckOption(std::abs(k1) <= 0.3, "rig.k1", k1, "must be in [-0.3, 0.3]");
}

Lens MakeLens(const RigOptions& options) {
  const double focal =
      options.focal_length * std::max(options.width, options.height);
  return {{options.width,
           options.height,
           focal,
           focal,
           options.width / 2.0,
           options.height / 2.0},
          options.k1};
}

Rigid3d LookAt(const Eigen::Vector3d& eye,
               const Eigen::Vector3d& target,
               const Eigen::Vector3d& up) {
  const Eigen::Vector3d forward = (target - eye).normalized();
  Eigen::Vector3d right = forward.cross(up);
  if (right.norm() < 1e-6) {
    right = forward.cross(Eigen::Vector3d(up.z(), up.x(), up.y()));
  }
  right.normalize();
  Rigid3d cam_from_world;
  cam_from_world.rotation.row(0) = right;
  cam_from_world.rotation.row(1) = forward.cross(right);
  cam_from_world.rotation.row(2) = forward;
  cam_from_world.translation = -(cam_from_world.rotation * eye);
  return cam_from_world;
}

namespace {

Eigen::Vector3d FromAngles(double azimuth, double sine_of_elevation) {
  const double radius =
      std::sqrt(std::max(0.0, 1 - sine_of_elevation * sine_of_elevation));
  return {radius * std::cos(azimuth),
          radius * std::sin(azimuth),
          sine_of_elevation};
}

std::vector<Eigen::Vector3d> SphereDirections(const RigOptions& options) {
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<Eigen::Vector3d> directions;
  for (int i = 0; i < options.num_views; ++i) {
    const double elevation = options.min_elevation +
                             (options.max_elevation - options.min_elevation) *
                                 (i + 0.5) / options.num_views;
    directions.push_back(
        FromAngles(golden_angle * i, std::sin(Radians(elevation))));
  }
  return directions;
}

std::vector<Eigen::Vector3d> RingDirections(const RigOptions& options) {
  const int num_rings = options.kind == RigKind::kTurntable ? 1 : 4;
  // As many views in a ring as its circumference asks for; the first ring
  // takes what rounding leaves.
  std::vector<double> elevations(num_rings);
  std::vector<int> counts(num_rings);
  double total = 0;
  for (int k = 0; k < num_rings; ++k) {
    elevations[k] = Radians(options.min_elevation +
                            (options.max_elevation - options.min_elevation) *
                                k / std::max(1, num_rings - 1));
    total += std::cos(elevations[k]);
  }
  int left = options.num_views;
  for (int k = num_rings - 1; k > 0; --k) {
    counts[k] = std::min(
        left,
        static_cast<int>(
            std::lround(options.num_views * std::cos(elevations[k]) / total)));
    left -= counts[k];
  }
  counts[0] = left;
  std::vector<Eigen::Vector3d> directions;
  for (int k = 0; k < num_rings; ++k) {
    for (int i = 0; i < counts[k]; ++i) {
      const double azimuth =
          2 * std::numbers::pi * (i + 0.5 * (k % 2)) / counts[k];
      directions.push_back(FromAngles(azimuth, std::sin(elevations[k])));
    }
  }
  return directions;
}

}  // namespace

std::vector<Rigid3d> MakeRig(const RigOptions& options,
                             const Eigen::Vector3d& center,
                             double radius) {
  options.Check();
  const Lens lens = MakeLens(options);
  // A sphere seen under the half angle asin(radius / distance).
  const double tangent = options.fill *
                         std::min(options.width, options.height) /
                         (2 * lens.camera.fx);
  const double distance = radius * std::sqrt(1 + 1 / (tangent * tangent));
  std::vector<Rigid3d> rig;
  for (const Eigen::Vector3d& direction : options.kind == RigKind::kSphere
                                              ? SphereDirections(options)
                                              : RingDirections(options)) {
    const double factor = rig.size() % 2 == 1 ? options.far_factor : 1;
    rig.push_back(LookAt(center + factor * distance * direction, center));
  }
  return rig;
}

}  // namespace octacut
