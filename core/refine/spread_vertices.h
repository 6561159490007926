// A subset of a mesh's vertices that covers the mesh evenly: patches of
// neighbouring vertices overlap so far that one of several will do.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/indexed_mesh.h"
#include "core/mesh/vertex_corners.h"

namespace octacut {

// Ascending indices of vertices with `eligible` != 0, no two of them within
// `distance` of each other along the edges of the mesh; each eligible vertex
// is within `distance` of one. `neighbors` are those of FindVertexNeighbors.
std::vector<uint32_t> SpreadVertices(const IndexedMesh& mesh,
                                     const VertexCorners& neighbors,
                                     const std::vector<uint8_t>& eligible,
                                     double distance);

}  // namespace octacut
