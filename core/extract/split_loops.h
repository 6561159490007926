// The polygons of a cut voxel: closed loops of its split edges, the cube
// edges where an inside face meets an outside face [HK06 section 5].
//
// Three faces meet in a corner of a cube, so a corner has no or two split
// edges: loops never touch, and a corner belongs to one loop at most. There
// are one loop (of 4, 6 or 8 corners) or two (of 4 each, when two opposite
// faces differ from the other four).
#pragma once

#include <array>
#include <cstdint>

#include "core/grid/face.h"

namespace octacut {

struct SplitLoop {
  int size = 0;
  // In order, counter-clockwise seen from the outside faces; starts at the
  // lowest corner.
  std::array<uint8_t, 8> corners{};
};

struct SplitLoops {
  int num_loops = 0;
  std::array<SplitLoop, 2> loops;
  uint8_t corner_mask = 0;  // corners in any loop
};

// Loops of each of the 2^6 labellings.
extern const std::array<SplitLoops, 64> kSplitLoopTable;

}  // namespace octacut
