// Points along a line of sight, at equal distances.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace octacut {

// Those inside of the root cube, in front of a camera at `center`, of a line
// with the unit vector `direction`, the nearest first. Unit coordinates;
// neighbours are 1 / `points_per_edge` apart.
std::vector<Eigen::Vector3f> PointsOnLine(const Eigen::Vector3f& center,
                                          const Eigen::Vector3f& direction,
                                          int points_per_edge);

}  // namespace octacut
