// One level of the hierarchy: from a crust to its labelling.
#pragma once

#include "core/crust/label_hierarchy.h"
#include "core/grid/voxel_grid.h"
#include "core/pipeline/level_steps.h"
#include "core/pipeline/summary.h"

namespace octacut {

// The labelling of l0: a first cut by the evidence alone gives a surface that
// visibility can be estimated from, the second one the labelling.
SolvedLevel SolveInitialLevel(const LevelInputs& inputs,
                              const VoxelGrid& hull,
                              LevelSummary* summary);

// The labelling of the level after hierarchy.Finest(); its crust is grown
// where the cut touches its border.
SolvedLevel SolveFinerLevel(const LevelInputs& inputs,
                            const LabelHierarchy& hierarchy,
                            LevelSummary* summary);

// The labelling of a crust that does not grow. `surface` are the labels of its
// voxels by the best surface that is known, from which visibility is estimated;
// `evidence` is added to that of the silhouettes, and empty if there is none.
SolvedLevel CutByPhotographs(Crust crust,
                             const std::vector<FaceLabels>& surface,
                             const std::vector<float>& evidence,
                             const SilhouetteTerms& silhouettes,
                             LevelSteps* steps);

// Bytes that the last level will need at its peak, roughly, for a surface of
// that area in unit coordinates.
size_t EstimateLevelBytes(double area, const ReconstructionOptions& options);

}  // namespace octacut
