// A prism that crops clouds: Tanks and Temples gives one for each scene.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace octacut {

// What Open3D calls a SelectionPolygonVolume: the points between two planes
// orthogonal to an axis whose projection along it is in a polygon.
struct CropPolygon {
  int axis = 2;  // 0, 1 or 2
  double axis_min = 0;
  double axis_max = 0;
  std::vector<Eigen::Vector3d> polygon;

  // By the even-odd rule, as Open3D does.
  bool Contains(const Eigen::Vector3d& point) const;
};

}  // namespace octacut
