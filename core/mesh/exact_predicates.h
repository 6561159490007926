// Orientation of points decided exactly: a filter in double precision
// (Shewchuk 1997, stage A), then arithmetic on expansions, sums of doubles
// that do not overlap, which is exact. Right for all finite coordinates whose
// products neither overflow nor underflow (magnitudes from 1e-70 to 1e70, or
// zero).
#pragma once

#include <Eigen/Core>

namespace octacut {

// The sign (-1, 0, 1) of det [a - d, b - d, c - d]: zero when the four are in
// one plane, positive when d is on the side of the plane of a, b, c from which
// these appear clockwise.
int Orient3d(const Eigen::Vector3d& a,
             const Eigen::Vector3d& b,
             const Eigen::Vector3d& c,
             const Eigen::Vector3d& d);

// The sign of the area of a, b, c projected along axis `drop` (0, 1 or 2);
// zero when they are collinear there.
int Orient2d(const Eigen::Vector3d& a,
             const Eigen::Vector3d& b,
             const Eigen::Vector3d& c,
             int drop);

}  // namespace octacut
