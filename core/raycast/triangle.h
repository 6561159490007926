// Exact (double precision) geometry of one triangle.
#pragma once

#include <Eigen/Core>

namespace octacut {

// The point of triangle (a, b, c) nearest to `query`. Triangles of no area
// are legal: they are their edges.
Eigen::Vector3d ClosestPointOnTriangle(const Eigen::Vector3d& query,
                                       const Eigen::Vector3d& a,
                                       const Eigen::Vector3d& b,
                                       const Eigen::Vector3d& c);

}  // namespace octacut
