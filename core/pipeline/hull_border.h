// Vertices of the cut that are as near to the visual hull's border as the cut
// is known.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/context.h"
#include "core/grid/voxel_grid.h"
#include "core/mesh/indexed_mesh.h"
#include "core/scene/scene.h"
#include "core/views/view_set.h"

namespace octacut {

// The visual hull, by the silhouettes of the views.
struct SilhouetteHull {
  const ViewSet& views;
  const std::vector<float>& mask_confidence;  // one per view: InsideEvidence
  const BoundingCube& cube;
};

// How far photographs decide on the surface.
struct DecidedVoxels {
  const VoxelGrid& voxels;
  const std::vector<float>& decided;  // one per voxel, 0 .. 1
};

// Moves vertices that are within a voxel (or a pixel, the larger of both) of
// the border of the hull towards it, along their normals. Every line of sight
// along the border touches the surface, so that many vertices are near it
// because the surface is on it. How likely that is at a depth, the depths of
// all vertices tell: surfaces inside of the hull have any depth. Such a vertex
// moves to the mean of cut and border, weighted by how well each is known.
// (docs/experiments/hull_border.md)
//
// `mesh` has normals, which are made anew. Positions are floats before and
// after, and no triangles intersect, or are lower than kMinTriangleHeight,
// but those that did or were. Returns how many vertices were moved.
size_t MoveToHullBorder(const SilhouetteHull& hull,
                        const DecidedVoxels& decided,
                        const Context& context,
                        IndexedMesh* mesh);

}  // namespace octacut
