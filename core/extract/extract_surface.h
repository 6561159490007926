// Closed 2-manifold from a labelling of voxel faces [HK06 section 5].
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/extract/corner_umbrellas.h"
#include "core/grid/face.h"
#include "core/grid/voxel_grid.h"
#include "core/mesh/indexed_mesh.h"
#include "core/scene/scene.h"

namespace octacut {

struct ExtractSurfaceSummary {
  size_t num_polygons = 0;            // loops of split edges
  size_t num_four_polygon_edges = 0;  // grid edges with labels in/out/in/out
  size_t num_split_vertices = 0;  // extra copies of corners, one per umbrella
  // Polygons drawn as a fan around the centre of their voxel, as their
  // triangles would run through each other or lie on another polygon's.
  size_t num_fans = 0;
  // Vertices by the middle of a grid edge, where two pairs of polygons would
  // have the same edge.
  size_t num_edge_vertices = 0;
};

struct ExtractedSurface {
  // Positions are voxel corners (close to the middles of grid edges, centres of
  // voxels for the extra vertices above) in world coordinates, and triangles do
  // not intersect; no normals, no colours.
  // PositionVertices moves them to where they belong.
  IndexedMesh mesh;
  // The octants around each vertex that the voxels of its polygons fill.
  std::vector<OctantMask> octants;
  double voxel_size = 0;  // in world units
  ExtractSurfaceSummary summary;
};

// `labels` has one element per voxel of `crust`; voxels that share a face agree
// on it. Each loop of split edges in a cut voxel becomes one polygon with its
// vertices at voxel corners, triangulated and oriented outward. Edges where
// four polygons meet are paired by one rule (never join through an inside
// face), each umbrella gets its own vertex, and no two triangles lie in the
// same place: the result is a closed, oriented 2-manifold without degenerate
// or intersecting triangles for every labelling, even though umbrellas may
// touch at a corner. Vertices
// and triangles follow the Morton order of the voxels. A labelling without a
// cut voxel gives an empty mesh.
//
// Throws InputError when the labels do not bound a volume: sizes differ,
// neighbours disagree about a face, or the surface ends at the border of the
// crust (a voxel outside the crust has faces of both kinds).
ExtractedSurface ExtractSurface(const VoxelGrid& crust,
                                std::span<const FaceLabels> labels,
                                const BoundingCube& cube,
                                const Context& context);

}  // namespace octacut
