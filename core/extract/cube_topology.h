// Corners, edges and faces of a voxel.
//
// Corner k lies at (k & 1, k >> 1 & 1, k >> 2 & 1); faces as in
// core/grid/face.h. The octants around a grid corner are numbered the same
// way: bit a of octant o is set when it lies on the + side along axis a, so
// the voxel in octant o sees the grid corner as its own corner 7 ^ o.
#pragma once

#include <bit>
#include <cstdint>

#include "core/grid/face.h"

namespace octacut {

inline constexpr int kNumCorners = 8;

inline constexpr int NextAxis(int axis) { return (axis + 1) % 3; }

// Axes along which corners a and b of a cube agree, as a bit mask. Two bits:
// a and b span a cube edge; one: a face diagonal; none: a body diagonal.
inline constexpr unsigned SharedAxes(int a, int b) {
  return ~unsigned(a ^ b) & 7u;
}
inline constexpr bool IsFaceDiagonal(int a, int b) {
  return std::popcount(SharedAxes(a, b)) == 1;
}

// The face of a cube that corner k touches across `axis`.
inline constexpr int FaceAtCorner(int k, int axis) {
  return 2 * axis + (k >> axis & 1);
}

// Whether the cube edge between corners a and b is split: an inside and an
// outside face meet in it.
inline constexpr bool IsSplitEdge(FaceLabels labels, int a, int b) {
  const unsigned axes = SharedAxes(a, b);
  const int first = std::countr_zero(axes);
  const int second = std::bit_width(axes) - 1;
  return (labels >> FaceAtCorner(a, first) & 1) !=
         (labels >> FaceAtCorner(a, second) & 1);
}

// A number in [0, 24) for every pair of corners that voxels can share (12
// face diagonals, 12 cube edges); -1 for body diagonals, which they cannot.
inline constexpr int ChordNumber(int a, int b) {
  const unsigned axes = SharedAxes(a, b);
  if (std::popcount(axes) == 1) {
    const int axis = std::countr_zero(axes);
    const int next = NextAxis(axis);
    return 2 * FaceAtCorner(a, axis) +
           ((a >> next & 1) == (a >> NextAxis(next) & 1) ? 0 : 1);
  }
  if (std::popcount(axes) == 2) {
    const int axis = std::countr_zero(~axes & 7u);
    const int next = NextAxis(axis);
    return 12 + 4 * axis + (a >> next & 1) + 2 * (a >> NextAxis(next) & 1);
  }
  return -1;
}

}  // namespace octacut
