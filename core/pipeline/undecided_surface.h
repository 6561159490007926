// What becomes of the surface where the photographs do not decide.
//
// A minimum cut through voxels that all cost the same shrinks the object by as
// much as each crust allows, level by level, and one through voxels of random
// cost follows the noise. Where photo-consistency says nothing, the surface of
// the coarser level is therefore the best guess, or the visual hull, where that
// is near and the photographs have not decided the coarser levels either.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/crust/crust.h"
#include "core/grid/face.h"
#include "core/grid/voxel_values.h"
#include "core/pipeline/options.h"

namespace octacut {

// How far the photographs decide on the surface near each voxel of a crust,
// 0 .. 1.
struct Decision {
  // By their agreement near the voxel, as far as that is reliable.
  std::vector<float> here;
  // By their agreement around it, or the confidence in depths and dents.
  std::vector<float> around;
};

// `confidence` is the decision_confidence of InsideEvidence.
Decision DecideByPhotographs(const Crust& crust,
                             const std::vector<float>& phi,
                             const VoxelValues& confidence,
                             const Context& context);

// The share of the cut voxels that the photographs decide.
double DecidedShare(const std::vector<FaceLabels>& labels,
                    const Decision& decision);

// The weights with which the level is cut: those that EdgeWeights makes of
// `phi`, which approach those of voxels that nobody sees where nothing is
// decided.
std::vector<float> DecidedWeights(const Decision& decision,
                                  const std::vector<float>& phi,
                                  const ReconstructionOptions& options);

// Halves `weights` on the border of the visual hull where the photographs
// decide, less within a voxel of it. Every line of sight along a border touches
// the surface, so that most of a surface that many views see lies on the hull
// or well inside of it, and where the photographs place it hardly inside, that
// is their error.
void FavorHullBorder(const Decision& decision,
                     const std::vector<float>& hull_depth,
                     std::vector<float>* weights);

// Adds to `evidence` of l0 what holds the border of the hull down to plates of
// one voxel: of a mirror there is no better guess, and where no ray shows the
// loss, a cut of least area leaves holes in plates.
void HoldHull(const std::vector<float>& hull_depth,
              std::vector<float>* evidence);

// Adds to `evidence` what holds the undecided surface where that of the coarser
// level is, by crust.prior, and lets it out to the border of the hull.
void HoldUndecidedSurface(const Crust& crust,
                          const Decision& decision,
                          const std::vector<float>& hull_depth,
                          const Context& context,
                          std::vector<float>* evidence);

}  // namespace octacut
