// Triangulations of the polygon of a cut voxel. For core/extract alone.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <span>
#include <vector>

namespace octacut {

// Positions in a loop, ascending; the orientation is the loop's.
using LoopTriangle = std::array<uint8_t, 3>;

// All triangulations of a convex polygon with `size` corners (4: 2, 6: 14,
// 8: 132 of them), each of size - 2 triangles; stored one after another.
const std::vector<LoopTriangle>& LoopTriangulations(int size);

// Triangles of triangulation `choice` of a loop.
inline std::span<const LoopTriangle> LoopTriangulation(int size, int choice) {
  return {LoopTriangulations(size).data() + size_t(choice) * (size - 2),
          size_t(size - 2)};
}

// The triangulation of the corners' best shape: the least sum over the
// triangles of (sum of squared edges) / (twice the area), in voxels, which is
// least for equilateral triangles, and large but finite for degenerate ones.
// The first of equals.
int ChooseTriangulation(std::span<const Eigen::Vector3f> corners);

}  // namespace octacut
