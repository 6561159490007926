// A level's surface once more, in a crust around a mesh.
#pragma once

#include "core/crust/label_hierarchy.h"
#include "core/grid/voxel_grid.h"
#include "core/mesh/indexed_mesh.h"
#include "core/pipeline/level_steps.h"
#include "core/pipeline/summary.h"

namespace octacut {

// The labelling of `level` in the crust around `mesh` (unit coordinates, as
// RefineSurface returns it): as wide as that of RefineCrust, with the mesh as
// the surface that is known so far. `hierarchy` becomes the mesh's labels of
// `hull`, the visual hull of the level before.
SolvedLevel RecutLevel(const LevelInputs& inputs,
                       const VoxelGrid& hull,
                       const IndexedMesh& mesh,
                       LabelHierarchy* hierarchy,
                       LevelSummary* summary);

}  // namespace octacut
