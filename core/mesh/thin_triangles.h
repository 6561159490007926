// Keeps moved vertices from squeezing triangles to nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"

namespace octacut {

// Whether the height over the longest edge is below `min_height` (in the unit
// of the positions).
bool IsThin(const std::vector<Eigen::Vector3d>& positions,
            const std::array<uint32_t, 3>& triangle,
            double min_height);

struct WithdrawSummary {
  size_t num_withdrawn = 0;  // vertices that were not left where they moved
  size_t num_thin = 0;       // triangles that are too thin even at `start`
};

// Moves the vertices of thin triangles back towards `start`, in steps of a
// half, a quarter, an eighth of their way and then all of it, until no triangle
// is thin. Succeeds whenever no triangle is thin at `start`, since each vertex
// moves only towards it.
WithdrawSummary WithdrawFromThinTriangles(
    const std::vector<std::array<uint32_t, 3>>& triangles,
    const std::vector<Eigen::Vector3d>& start,
    double min_height,
    const Context& context,
    std::vector<Eigen::Vector3d>& positions);

}  // namespace octacut
