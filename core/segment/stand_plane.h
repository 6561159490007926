// The plane that an object stands on, from sparse points.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <span>

#include "core/segment/search_region.h"

namespace octacut {

struct StandPlane {
  // The normal has unit length; object and cameras are on the positive side.
  Eigen::Hyperplane<double, 3> plane;
  // Distance up to which points lie on it: a pixel of the views at the centre
  // of the region.
  double tolerance = 0;
};

// The plane that most points lie on, of those that have nothing below them:
// nearly all cameras and the centre of the region are above, and hardly any
// points within twice the region's radius are below. Points farther away do
// not count. The same result for the same points in the same order. Nothing
// where there is no such plane, or where less than 30 points are near.
std::optional<StandPlane> FindStandPlane(
    std::span<const Eigen::Vector3d> points,
    std::span<const Pose> poses,
    const SearchRegion& region);

}  // namespace octacut
