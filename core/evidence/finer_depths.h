// Depths that are found again on a finer level than that of the first sweep,
// from just before the present surface to some way into it.
//
// Folds narrower than the windows of the first sweep have no depths from it,
// and stay filled: their surface is the one across their mouths. Windows of a
// finer level fit into them.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/evidence/inside_evidence.h"
#include "core/grid/labeled_voxels.h"
#include "core/grid/voxel_grid.h"
#include "core/views/view_set.h"

namespace octacut {

struct FinerEvidence {
  // The surface's crust, and what lies between it and confirmed depths behind
  // it; empty where hardly any depth lies there.
  VoxelGrid voxels;
  // One per voxel, as InsideEvidence has it without ballooning: 0 where no
  // depth says anything.
  std::vector<float> values;
};

// `surface` is the labelled crust of the level whose voxels the depths are
// found in; `depth_confidence` as that of InsideEvidence. Where that is less
// than a half nothing is looked for: finer windows see the same reflections. An
// eighth of space is looked at first, and where hardly any depth leads into the
// surface there, that is all.
FinerEvidence FindFinerDepths(const ViewSet& views,
                              const LabeledVoxels& surface,
                              const VoxelValues& depth_confidence,
                              const InsideEvidenceOptions& options,
                              const Context& context);

}  // namespace octacut
