// Points spread evenly over a mesh, some vertices apart: patches of
// neighbouring vertices overlap so far that it is enough to measure at one of
// several and to solve for one unknown there.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/indexed_mesh.h"
#include "core/mesh/vertex_corners.h"

namespace octacut {

struct SurfacePoints {
  std::vector<uint32_t> vertices;  // of the mesh, ascending; one per point
  // For each vertex of the mesh, the closest point that reaches it.
  std::vector<uint32_t> point_of;
  // For each point, those whose vertices are joined with its own by an edge,
  // ascending.
  VertexCorners neighbors;
};

// Every vertex is within `distance` (in a straight line) of a point, and no two
// points are within `distance` of each other that are connected by vertices
// within it. `neighbors` are those of
// FindVertexNeighbors.
SurfacePoints SpreadPoints(const IndexedMesh& mesh,
                           const VertexCorners& neighbors,
                           double distance);

}  // namespace octacut
