// Projection of points of the root cube into a view, in single precision.
//
// Frame: unit coordinates, those of BoundingCube::ToUnit, so the
// cube is [0, 1]^3 and a voxel of level l has edge 2^-l whatever the scale of
// the sparse model. Depths are in the same unit.
#pragma once

#include <algorithm>
#include <Eigen/Core>
#include <Eigen/LU>
#include <optional>

#include "core/scene/scene.h"

namespace octacut {

// Where a view shows a point that is before its camera.
struct ProjectedPoint {
  float u;      // pixels of the view from its left edge: the centre of the
  float v;      // first pixel is at 0.5, 0.5; may lie out of the frame
  float depth;  // along the optical axis, unit coordinates, > 0
};

struct ViewProjection {
  static constexpr float kNearestCenter = 0.25f;  // unit coordinates

  // (u * depth, v * depth, depth) = linear * x + offset; u, v in pixels.
  Eigen::Matrix3f linear;
  Eigen::Vector3f offset;
  Eigen::Vector3f center;  // of the camera
  float focal_length = 0;  // pixels, mean of fx and fy
  int width = 0;
  int height = 0;

  Eigen::Vector3f Homogeneous(const Eigen::Vector3f& x) const {
    return linear * x + offset;
  }
  // Times (u, v, 1): from the camera to the point that the view shows there at
  // depth 1.
  Eigen::Matrix3f RaysOfPixels() const { return linear.inverse(); }
  // None for a point that is not before the camera.
  std::optional<ProjectedPoint> Project(const Eigen::Vector3f& x) const {
    const Eigen::Vector3f h = Homogeneous(x);
    if (!(h.z() > 0)) {
      return std::nullopt;
    }
    return ProjectedPoint{h.x() / h.z(), h.y() / h.z(), h.z()};
  }
  // Pixels that a length at the depth covers.
  float Footprint(float length, float depth) const {
    return focal_length * length / depth;
  }
  // The same at the centre of the root cube. Close-ups have that nearer than
  // what they show, or behind them: they count as if it were at kNearestCenter.
  float CenterFootprint(float length) const {
    const float depth = Homogeneous(Eigen::Vector3f::Constant(0.5f)).z();
    return Footprint(length, std::max(depth, kNearestCenter));
  }
  bool InFrame(float u, float v) const {
    return u >= 0 && v >= 0 && u <= float(width) && v <= float(height);
  }
  // None, too, for a point that is out of the frame.
  std::optional<ProjectedPoint> ProjectIntoFrame(
      const Eigen::Vector3f& x) const {
    const std::optional<ProjectedPoint> point = Project(x);
    return point && InFrame(point->u, point->v) ? point : std::nullopt;
  }
};

ViewProjection MakeViewProjection(const View& view, const BoundingCube& cube);

// Centre of a voxel of level `level` in unit coordinates.
inline Eigen::Vector3f VoxelCenter(const Eigen::Vector3i& voxel, int level) {
  return (voxel.cast<float>() + Eigen::Vector3f::Constant(0.5f)) /
         float(1 << level);
}

}  // namespace octacut
