// Which triangles share edges.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

inline constexpr uint32_t kNoFace = std::numeric_limits<uint32_t>::max();

// For each triangle its neighbours across the edges from corner k to corner
// k + 1; kNoFace at the border of an open mesh and at edges of more than two
// triangles.
std::vector<std::array<uint32_t, 3>> FindFaceNeighbors(const IndexedMesh& mesh);

}  // namespace octacut
