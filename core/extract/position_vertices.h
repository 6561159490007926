// Where the vertices of an extracted surface begin.
//
// Labels make the surface run along one side of the cut voxels, half a voxel
// inside or outside of where the cut passes, according to which of equal cuts
// was found. Each vertex moves from its voxel corner to the mean of the
// centres of the voxels whose polygons it belongs to; that is at most half a
// voxel's diagonal away, and unbiased.
#pragma once

#include "core/base/context.h"
#include "core/extract/extract_surface.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

// No triangles of the mesh intersect, and none is lower than
// kMinTriangleHeight: where they would be, vertices stay closer to their
// corners, where every triangle is higher than 0.4 voxels and none intersect.
IndexedMesh PositionVertices(ExtractedSurface surface, const Context& context);

}  // namespace octacut
