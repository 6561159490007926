// The octahedron inside a voxel, and the arcs of a face node, as tables.
//
// Around face f of axis a the four perpendicular faces are counted by
// j = 0 .. 3: axes (a + 1) % 3 and (a + 2) % 3, low face before high. The arc
// from f to its j-th face is number 4 f + j, which is also its bit in a
// voxel's mask of residual arcs. Two opposite arcs share one of twelve edges.
//
// A node is a face between two voxels and belongs to the upper one, whose low
// face it is; it has four arcs in that voxel (side 0) and four in the lower
// voxel (side 1), whose high face it is. Its arc to the j-th face around it on
// a side has code 4 side + j.
#pragma once

#include <array>
#include <cstdint>

#include "core/grid/face.h"

namespace octacut {

inline constexpr int kNumOctahedronEdges = 12;
inline constexpr int kNumOctahedronArcs = 24;
inline constexpr int kNumNodeArcs = 8;

// The j-th face around a face.
inline constexpr int FaceAround(int face, int j) {
  return 2 * ((face / 2 + 1 + j / 2) % 3) + (j & 1);
}

// Which of the faces around FaceAround(face, j) is `face`.
inline constexpr int BackAround(int face, int j) {
  return (j < 2 ? 2 : 0) + (face & 1);
}

struct OctahedronTables {
  uint8_t head[kNumOctahedronArcs] = {};     // face an arc leads to
  uint8_t reverse[kNumOctahedronArcs] = {};  // the arc the other way
  uint8_t edge[kNumOctahedronArcs] = {};     // edge of an arc
  int8_t sign[kNumOctahedronArcs] = {};      // +1 along the edge, -1 against
};

inline constexpr OctahedronTables MakeOctahedronTables() {
  OctahedronTables tables;
  int num_edges = 0;
  for (int arc = 0; arc < kNumOctahedronArcs; ++arc) {
    const int face = arc / 4;
    const int other = FaceAround(face, arc % 4);
    const int reverse = 4 * other + BackAround(face, arc % 4);
    tables.head[arc] = uint8_t(other);
    tables.reverse[arc] = uint8_t(reverse);
    if (face < other) {
      tables.edge[arc] = tables.edge[reverse] = uint8_t(num_edges++);
      tables.sign[arc] = 1;
      tables.sign[reverse] = -1;
    }
  }
  return tables;
}
inline constexpr OctahedronTables kOctahedron = MakeOctahedronTables();

// What a node needs to know of one of its arcs; of a size that finds one in a
// table by a shift.
struct alignas(8) NodeArc {
  uint8_t side;  // voxel that holds the arc: 0 the node's own, 1 the lower
  uint8_t step;  // face to step across from there to the other node's voxel,
                 // kNumFaces: none
  uint8_t axis;  // of the other node
  uint8_t back;  // code of the same arc at the other node
  uint8_t out;   // number of the arc that leaves the node
  uint8_t in;    // number of the arc that enters it
};

inline constexpr std::array<std::array<NodeArc, kNumNodeArcs>, 3>
MakeNodeArcs() {
  std::array<std::array<NodeArc, kNumNodeArcs>, 3> arcs = {};
  for (int axis = 0; axis < 3; ++axis) {
    for (int code = 0; code < kNumNodeArcs; ++code) {
      const int side = code / 4;
      const int out = 4 * (2 * axis + side) + code % 4;
      const int other = kOctahedron.head[out];
      const int in = kOctahedron.reverse[out];
      arcs[axis][code] = {uint8_t(side),
                          uint8_t((other & 1) ? other : kNumFaces),
                          uint8_t(other / 2),
                          uint8_t(4 * (other & 1) + in % 4),
                          uint8_t(out),
                          uint8_t(in)};
    }
  }
  return arcs;
}
// By axis and code.
inline constexpr std::array<std::array<NodeArc, kNumNodeArcs>, 3> kNodeArcs =
    MakeNodeArcs();

// The codes that the arcs of a node have at its neighbours.
inline constexpr std::array<std::array<int32_t, kNumNodeArcs>, 3>
MakeBackCodes() {
  std::array<std::array<int32_t, kNumNodeArcs>, 3> codes = {};
  for (int axis = 0; axis < 3; ++axis) {
    for (int code = 0; code < kNumNodeArcs; ++code) {
      codes[axis][code] = kNodeArcs[axis][code].back;
    }
  }
  return codes;
}
inline constexpr std::array<std::array<int32_t, kNumNodeArcs>, 3> kBackCodes =
    MakeBackCodes();

// The six voxels that hold a node's arcs and the nodes at their other ends:
// the node's own (0) and the lower one (1), and the voxels above each of these
// along the next axis (2, 4) and the last (3, 5). Which of them holds the
// other node, by code of the arc:
inline constexpr uint8_t kNodeArcHolder[kNumNodeArcs] = {
    0, 2, 0, 3, 1, 4, 1, 5};

// The four of a voxel's residual arcs that leave a face; bit j is the arc to
// its j-th face.
inline constexpr uint32_t ArcsOut(uint32_t residual, int face) {
  return (residual >> (4 * face)) & 15;
}

// The four that enter it; bit j is the arc from its j-th face.
inline constexpr uint32_t ArcsIn(uint32_t residual, int face) {
  const int high = face & 1;
  const uint32_t a = residual >> (8 * ((face / 2 + 1) % 3) + 2 + high);
  const uint32_t b = residual >> (8 * ((face / 2 + 2) % 3) + high);
  return (a & 1) | ((a >> 3) & 2) | ((b & 1) << 2) | ((b >> 1) & 8);
}

// Arcs of a voxel with these labels that lead from an outside face to an
// inside face.
inline constexpr std::array<uint32_t, 64> MakeLeavingArcs() {
  std::array<uint32_t, 64> leaving = {};
  for (int labels = 0; labels < 64; ++labels) {
    for (int arc = 0; arc < kNumOctahedronArcs; ++arc) {
      const bool from_outside = ((labels >> (arc / 4)) & 1) == 0;
      const bool to_inside = (labels >> kOctahedron.head[arc]) & 1;
      leaving[labels] |= uint32_t(from_outside && to_inside) << arc;
    }
  }
  return leaving;
}
inline constexpr std::array<uint32_t, 64> kLeavingArcs = MakeLeavingArcs();

// Arcs of a voxel between two faces that are not blocked, by blocked faces.
inline constexpr std::array<uint32_t, 64> MakeFreeArcs() {
  std::array<uint32_t, 64> free = {};
  for (int blocked = 0; blocked < 64; ++blocked) {
    for (int arc = 0; arc < kNumOctahedronArcs; ++arc) {
      const bool is_free = ((blocked >> (arc / 4)) & 1) == 0 &&
                           ((blocked >> kOctahedron.head[arc]) & 1) == 0;
      free[blocked] |= uint32_t(is_free) << arc;
    }
  }
  return free;
}
inline constexpr std::array<uint32_t, 64> kFreeArcs = MakeFreeArcs();

}  // namespace octacut
