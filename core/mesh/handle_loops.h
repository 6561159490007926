// Short loops around the handles of a closed mesh.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/surface_homology.h"

namespace octacut {

struct HandleLoop {
  double length = 0;                 // world units
  std::vector<uint32_t> half_edges;  // in order; no vertex twice
  uint64_t homology_class = 0;
};

// Loops of edges of at most `max_length` (world units) that do not cut the
// surface in two: for each edge in the way of such loops the shortest through
// its vertex, the shortest first. Many go around the same handle.
std::vector<HandleLoop> FindHandleLoops(const IndexedMesh& mesh,
                                        const SurfaceHomology& homology,
                                        double max_length,
                                        const Context& context);

}  // namespace octacut
