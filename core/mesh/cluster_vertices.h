// A coarse copy of a mesh for display, by clustering of vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct ClusteredMesh {
  // Positions and triangles only. May be neither closed nor manifold even where
  // the original is: good enough to look at, not to measure.
  IndexedMesh mesh;
  // For each of its vertices the one of the original that is nearest to it, of
  // those that it stands for: where values of the original are to be read.
  std::vector<uint32_t> sources;
  bool is_simplified = false;
};

// At most `max_triangles` (at least 100) triangles and at most as many
// vertices. The vertices in a cell of a cubic grid become one, at the place
// that fits the planes of their triangles best (quadrics as in Lindstrom 2000,
// kept inside the cell). Accepts any mesh; a mesh that is small enough comes
// back as it is, without vertices that no triangle uses. The same result for
// any number of threads. Throws InputError when there are no triangles or
// coordinates that are not finite.
ClusteredMesh ClusterVertices(const IndexedMesh& mesh,
                              size_t max_triangles,
                              const Context& context);

}  // namespace octacut
