// A level's surface once more, in a crust around a mesh.
#pragma once

#include "core/crust/label_hierarchy.h"
#include "core/grid/voxel_grid.h"
#include "core/mesh/indexed_mesh.h"
#include "core/pipeline/level_steps.h"
#include "core/pipeline/summary.h"

namespace octacut {

// The labelling of `level`, which is finer than that of `hull`, in the crust
// around `mesh` (within the unit cube, as RefineSurface returns it): as wide as
// that of RefineCrust, with the mesh as the surface that is known so far.
// `hierarchy` becomes the mesh's labels of the visual hull and of the levels
// between.
SolvedLevel RecutLevel(const LevelInputs& inputs,
                       const VoxelGrid& hull,
                       const IndexedMesh& mesh,
                       int level,
                       LabelHierarchy* hierarchy,
                       LevelSummary* summary);

}  // namespace octacut
