#include "core/extract/split_loops.h"

#include "core/extract/cube_topology.h"

namespace octacut {
namespace {

// Corners of a face, clockwise seen from outside the cube: the polygon looks
// at its inside face from within the voxel.
constexpr std::array<int, 4> ClockwiseCorners(int face) {
  const int axis = face / 2;
  const int u = 1 << NextAxis(axis);
  const int v = 1 << NextAxis(NextAxis(axis));
  const int base = (face & 1) << axis;
  if (face & 1) {
    return {base, base | v, base | u | v, base | u};
  }
  return {base, base | u, base | u | v, base | v};
}

constexpr SplitLoops TraceLoops(FaceLabels labels) {
  std::array<int, kNumCorners> next{};
  next.fill(-1);
  for (int face = 0; face < kNumFaces; ++face) {
    if ((labels >> face & 1) == 0) {
      continue;
    }
    const std::array<int, 4> corners = ClockwiseCorners(face);
    for (int i = 0; i < 4; ++i) {
      const int from = corners[i];
      const int to = corners[(i + 1) % 4];
      if (IsSplitEdge(labels, from, to)) {
        next[from] = to;
      }
    }
  }
  SplitLoops result;
  for (int start = 0; start < kNumCorners; ++start) {
    if (next[start] < 0 || (result.corner_mask >> start & 1)) {
      continue;
    }
    SplitLoop& loop = result.loops[result.num_loops++];
    int corner = start;
    do {
      loop.corners[loop.size++] = uint8_t(corner);
      result.corner_mask |= uint8_t(1u << corner);
      corner = next[corner];
    } while (corner != start);
  }
  return result;
}

constexpr std::array<SplitLoops, 64> TraceAll() {
  std::array<SplitLoops, 64> table{};
  for (int labels = 0; labels < 64; ++labels) {
    table[labels] = TraceLoops(FaceLabels(labels));
  }
  return table;
}

}  // namespace

constexpr std::array<SplitLoops, 64> kSplitLoopTable = TraceAll();

}  // namespace octacut
