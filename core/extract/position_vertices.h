// Where the vertices of an extracted surface begin.
//
// Labels make the surface run along one side of the cut voxels, half a voxel
// inside or outside of where the cut passes, according to which of equal cuts
// was found. Each vertex moves from its voxel corner to the mean of the
// centres of the voxels whose polygons it belongs to; that is at most half a
// voxel's diagonal away, and unbiased.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/extract/extract_surface.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct PositionVerticesOptions {
  // Least height of a triangle over its longest edge, in voxels. Parts that
  // are thinner than a voxel would collapse or run into each other: their
  // vertices stay closer to their corners, where every triangle is higher than
  // 0.4 voxels and none intersect.
  double min_height = 0.02;

  void Check() const;
};

struct PositionedSurface {
  IndexedMesh mesh;
  // The voxel corner (or the middle of a grid edge, or the centre of a voxel)
  // where each vertex was before, in world coordinates.
  std::vector<Eigen::Vector3d> corners;
};

// No triangles of the mesh intersect.
PositionedSurface PositionVertices(ExtractedSurface surface,
                                   const PositionVerticesOptions& options,
                                   const Context& context);

}  // namespace octacut
