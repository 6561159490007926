// Where the object can be, from cameras alone.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <span>

#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace octacut {

// Where a camera stands and what it shows.
struct Pose {
  PinholeCamera camera;
  Rigid3d cam_from_world;
};

// Where the object is said to be.
struct SearchBounds {
  std::optional<Eigen::AlignedBox3d> box;
  // The object is on the positive side.
  std::optional<Eigen::Hyperplane<double, 3>> floor;

  bool Contain(const Eigen::Vector3d& point) const {
    return (!box || box->contains(point)) &&
           (!floor || floor->signedDistance(point) >= 0);
  }
};

struct SearchRegion {
  // The point that the cameras look at, or the centre of the given box.
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  // Half of the views show all of the ball of this radius around the centre;
  // with a box: of the ball that is as wide as the box in the mean.
  double radius = 0;
  // Holds what is to be searched.
  BoundingCube cube;
  std::optional<Eigen::AlignedBox3d> box;  // as given
};

// The point that the axes of most cameras pass (least sum of distances), and
// around it what the frames allow: Campbell et al. (BMVC 2007) call it the
// fixation of the cameras.
//
// Throws InputError when there are fewer than three views, when all cameras
// look in the same direction, or when most do not show a common point.
SearchRegion FindSearchRegion(std::span<const Pose> poses,
                              const std::optional<Eigen::AlignedBox3d>& box);

// CV_32F of the view's size: how far the rays of its pixels pass the centre, in
// radii of the region.
cv::Mat DistancesFromCenter(const Pose& pose, const SearchRegion& region);

// Where the view shows a point; none if it does not.
std::optional<Eigen::Vector2d> PixelOf(const Pose& pose,
                                       const Eigen::Vector3d& point);

}  // namespace octacut
