// The triangulation of every polygon by its shape alone. For core/extract
// alone.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/extract/cube_topology.h"
#include "core/extract/cut_voxels.h"
#include "core/extract/split_loops.h"
#include "core/extract/triangulate_loop.h"
#include "core/extract/umbrella_vertices.h"

namespace octacut {

struct LoopChoices {
  // The number of each cut voxel's triangulation; if it has two loops, the
  // second one's counts in units of 2.
  std::vector<uint8_t> codes;
  // The chords that each cut voxel draws, as bits of ChordNumber.
  std::vector<uint32_t> chords;

  int OfLoop(CutVoxels::Index number, const SplitLoops& loops, int i) const {
    const int code = codes[number];
    return loops.num_loops == 1 ? code : (i == 0 ? code & 1 : code >> 1);
  }
};

// Calls body(a, b) for the chords of a triangulated loop, as corners.
template <typename Body>
void ForEachChord(const SplitLoop& loop, int choice, Body&& body) {
  for (const LoopTriangle& triangle : LoopTriangulation(loop.size, choice)) {
    // Positions ascend: every chord joins the first and the last corner of
    // exactly one triangle, and so does the loop's closing edge.
    if (triangle[0] != 0 || triangle[2] != loop.size - 1) {
      body(int(loop.corners[triangle[0]]), int(loop.corners[triangle[2]]));
    }
  }
}

// Whether triangles of a loop run through each other with its vertices at the
// corners: two body diagonals do, in the middle of the voxel.
inline bool CrossesItself(const SplitLoop& loop, int choice) {
  int num_body_diagonals = 0;
  ForEachChord(loop, choice, [&](int a, int b) {
    num_body_diagonals += ChordNumber(a, b) < 0 ? 1 : 0;
  });
  return num_body_diagonals > 1;
}

// Judges the shapes with each vertex at the mean of the centres of the voxels
// of its umbrella, where PositionVertices moves it.
LoopChoices ChooseLoops(const CutVoxels& cut,
                        const UmbrellaVertices& umbrellas,
                        const Context& context);

}  // namespace octacut
