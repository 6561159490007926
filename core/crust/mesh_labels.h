// Labels of voxels by a closed mesh: the way back from a mesh to the grid.
#pragma once

#include "core/base/context.h"
#include "core/grid/labeled_voxels.h"
#include "core/grid/voxel_grid.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

// The voxels of `level` in the root cube through which `mesh` (unit
// coordinates) passes: those that hold one of its points, which are looked at
// half a voxel apart.
VoxelGrid VoxelsOfMesh(const IndexedMesh& mesh, int level);

// `voxels` with the faces labelled whose centres lie inside of `mesh` (unit
// coordinates, closed, oriented outward, without self-intersections).
LabeledVoxels LabelByMesh(const IndexedMesh& mesh,
                          VoxelGrid voxels,
                          const Context& context);

}  // namespace octacut
