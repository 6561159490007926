// The six faces of a voxel, in the order x-, x+, y-, y+, z-, z+. The opposite
// of face f is f ^ 1; its axis is f / 2.
#pragma once

#include <cstdint>

namespace octacut {

inline constexpr int kNumFaces = 6;

// Bit f set: face f is inside (on the sink side of the cut). A voxel is cut
// when its labels are neither 0 nor kAllFaces.
using FaceLabels = uint8_t;
inline constexpr FaceLabels kAllFaces = 0x3f;

inline constexpr int OppositeFace(int face) { return face ^ 1; }
inline constexpr bool IsCut(FaceLabels labels) {
  return labels != 0 && labels != kAllFaces;
}

}  // namespace octacut
