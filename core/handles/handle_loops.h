// Short loops around the handles of a closed mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/handles/half_edges.h"
#include "core/handles/surface_homology.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct HandleLoop {
  double length = 0;                 // world units
  std::vector<uint32_t> half_edges;  // in order; no vertex twice
};

// Loops of edges of at most `max_length` (world units) that do not cut the
// surface in two, the shortest first: for each vertex that such a loop may run
// through, the shortest one through it. Where its two halves share their first
// edges, those are left out. Many go around the same handle, and some are the
// same.
std::vector<HandleLoop> FindHandleLoops(const IndexedMesh& mesh,
                                        const HalfEdges& half_edges,
                                        const SurfaceHomology& homology,
                                        double max_length,
                                        const Context& context);

}  // namespace octacut
