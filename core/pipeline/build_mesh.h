// The steps from the evidence to the mesh: the levels of the hierarchy, the
// extraction, and the refinement.
#pragma once

#include <functional>

#include "core/base/context.h"
#include "core/evidence/inside_evidence.h"
#include "core/grid/labeled_voxels.h"
#include "core/grid/voxel_grid.h"
#include "core/mesh/indexed_mesh.h"
#include "core/pipeline/finish_mesh.h"
#include "core/pipeline/options.h"
#include "core/pipeline/summary.h"
#include "core/scene/scene.h"
#include "core/views/view_set.h"

namespace octacut {

// Receives the hull (level -1) and every level's surface, before smoothing;
// again if the level is cut again.
using LevelObserver = std::function<void(int level, const IndexedMesh& mesh)>;

struct BuildInputs {
  const VoxelGrid& hull;  // its level is l0
  const InsideEvidence& evidence;
  const BoundingCube& cube;
  const ReconstructionOptions& options;
  const Context& context;
  const LevelObserver& observer;
};

struct BuiltMesh {
  FinishedMesh finished;  // world coordinates
  LabeledVoxels surface;  // of the last level, which the mesh came from
};

// Where refinement carries the surface out of its crust, as in folds and
// hollows that the cut could not reach, the level after l0 is cut again around
// the refined surface, before the levels after it are solved, unless the
// photographs then agree less. Refinement aligns `views`, and what comes after
// it uses them so; the next refinement begins with the poses as given.
BuiltMesh BuildMesh(const BuildInputs& inputs,
                    ViewSet* views,
                    ReconstructionSummary* summary);

}  // namespace octacut
