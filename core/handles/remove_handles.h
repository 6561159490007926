// Removes the smallest handles of a closed mesh.
//
// Where neither the images nor the hull decide, a cut leaves bridges and
// pinholes of a voxel or two. After Guskov & Wood, Topological noise removal
// (Graphics Interface 2001), each is cut along the shortest loop around it and
// both sides are closed: that takes a bridge away and fills a tunnel.
#pragma once

#include <cstddef>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct RemoveHandlesSummary {
  size_t num_removed = 0;
  // Loops that were not cut: what closes them would be thin or run through
  // other triangles.
  size_t num_refused = 0;
};

struct RemovedHandles {
  IndexedMesh mesh;  // without normals and colours where handles were removed
  RemoveHandlesSummary summary;
};

// Removes handles around which there is a loop of edges of at most `max_length`
// (world units; 0: none) that does not cut the surface in two, or of twice that
// around a tunnel, the shortest first: the genus falls by one with each, no
// component falls apart. A handle all of whose loops are refused stays. `mesh`
// is to be closed, oriented and free of self-intersections, and stays so; its
// vertices and triangles keep their numbers. New triangles are no thinner than
// `min_height` (world units, thin_triangles.h).
RemovedHandles RemoveHandles(IndexedMesh mesh,
                             double max_length,
                             double min_height,
                             const Context& context);

}  // namespace octacut
