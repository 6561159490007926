// Closed 2-manifold from a labelling of voxel faces [HK06 section 5].
#pragma once

#include <cstddef>
#include <span>

#include "core/base/context.h"
#include "core/grid/face.h"
#include "core/grid/voxel_grid.h"
#include "core/mesh/indexed_mesh.h"
#include "core/scene/scene.h"

namespace octacut {

struct ExtractSurfaceSummary {
  size_t num_polygons = 0;          // loops of split edges
  size_t num_four_polygon_edges = 0;  // grid edges with labels in/out/in/out
  size_t num_split_vertices = 0;    // extra copies of corners, one per umbrella
  size_t num_double_diagonals = 0;  // fans re-drawn to avoid a shared diagonal
};

struct ExtractedSurface {
  IndexedMesh mesh;  // no normals, no colours
  // Where each vertex began: voxel-corner positions in world coordinates.
  ExtractSurfaceSummary summary;
};

// `labels` has one element a voxel of `crust`; voxels that share a face agree
// on it. Each loop of split edges in a cut voxel becomes one polygon with its
// vertices at voxel corners, triangulated and oriented outward. Edges where
// four polygons meet are paired by one rule (never join through an inside
// face), each umbrella gets its own vertex, and no diagonal is drawn twice:
// the result is a closed, oriented 2-manifold without degenerate triangles
// for every labelling, even though umbrellas may touch at a corner.
ExtractedSurface ExtractSurface(const VoxelGrid& crust,
                                std::span<const FaceLabels> labels,
                                const BoundingCube& cube,
                                const Context& context);

}  // namespace octacut
