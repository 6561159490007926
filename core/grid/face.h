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

// Ties of a voxel's faces. Bit f: face f is outside (tied to the source);
// bit 6 + f: face f is inside (tied to the sink). A face between two crust
// voxels is tied when either voxel says so; both kinds at once are an error.
using FaceTies = uint16_t;
inline constexpr FaceTies OutsideTie(int face) { return FaceTies(1u << face); }
inline constexpr FaceTies InsideTie(int face) {
  return FaceTies(1u << (6 + face));
}
inline constexpr FaceTies kAllOutside = 0x3f;
inline constexpr FaceTies kAllInside = 0x3f << 6;

}  // namespace octacut
