// The steps of one level of the hierarchy. Each adds its seconds and figures to
// the level's summary, so that the code that strings them together need not.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/base/stopwatch.h"
#include "core/crust/crust.h"
#include "core/cut/octahedral_cut.h"
#include "core/evidence/inside_evidence.h"
#include "core/evidence/uncovered_silhouettes.h"
#include "core/grid/labeled_voxels.h"
#include "core/pipeline/cover_silhouettes.h"
#include "core/pipeline/options.h"
#include "core/pipeline/summary.h"
#include "core/pipeline/undecided_surface.h"
#include "core/pipeline/voxel_terms.h"
#include "core/views/view_set.h"
#include "core/visibility/surface_shape.h"
#include "core/visibility/visibility.h"

namespace octacut {

// What all levels work on.
struct LevelInputs {
  const ViewSet& views;
  const InsideEvidence& evidence;  // of l0
  const ReconstructionOptions& options;
  const Context& context;
};

// The energy of a cut, one element of each per voxel.
struct CutTerms {
  std::vector<float> weights;   // of the edges
  std::vector<float> evidence;  // for inside (> 0) or outside, in their units
};

// What a level comes to.
struct SolvedLevel {
  LabeledVoxels surface;
  // How far the photographs decide on it, 0 .. 1, one element per voxel.
  std::vector<float> decided;
};

class LevelSteps {
 public:
  // Keeps references to what it is given.
  LevelSteps(const LevelInputs& inputs, int level, LevelSummary* summary);

  // Returns what `step` returns; its seconds count as work on the crust.
  template <typename Step>
  auto OnCrust(Step&& step) {
    return Timed(&summary_.crust_seconds, step);
  }

  Visibility EstimateVisibility(const VoxelGrid& surface,
                                const std::vector<FaceLabels>& labels);

  SilhouetteTerms EstimateSilhouettes(const VoxelGrid& voxels);

  // The terms of `crust`; `silhouettes` are those of its voxels.
  VoxelTerms EstimateTerms(const Visibility& visibility,
                           const Crust& crust,
                           const SilhouetteTerms& silhouettes);

  // Brings `terms` up to `crust`, which is at least as large: voxels that have
  // their terms keep them, so growing a crust costs what it adds.
  void ExtendTerms(const Visibility& visibility,
                   const Crust& crust,
                   VoxelTerms* terms);

  // The energy of a level after l0 by its terms, and how far photographs decide
  // there.
  CutTerms EnergyOf(const Crust& crust,
                    const VoxelTerms& terms,
                    Decision* decision) const;

  // `state`, if any, as SolveOctahedralCut has it.
  OctahedralCut Cut(const Crust& crust,
                    const CutTerms& terms,
                    OctahedralCutState* state);

  // What the first cut of l0, after so many rounds, leaves of the silhouettes.
  UncoveredSilhouettes FindMissed(const Crust& crust,
                                  const OctahedralCut& cut,
                                  int round);

  // Cuts again where `cut` leaves silhouettes uncovered that can be covered.
  void CoverSilhouettes(const Crust& crust,
                        const CoverPreference& preference,
                        CutTerms* terms,
                        OctahedralCutState* state,
                        OctahedralCut* cut);

  // Grows `crust` where `cut` touches its border, unless it has grown `round`
  // times already and may not again. Whether it has grown.
  bool GrowCrust(const LabelHierarchy& hierarchy,
                 const OctahedralCut& cut,
                 int round,
                 Crust* crust);

  SolvedLevel Finish(Decision decision, Crust crust, OctahedralCut cut);

 private:
  // Those of the added voxels.
  std::vector<SurfaceShape> ShapesOf(const Crust& crust,
                                     const AddedVoxels& added);
  // `silhouettes` are those of the added voxels.
  VoxelTerms AddTerms(const Visibility& visibility,
                      const Crust& crust,
                      const AddedVoxels& added,
                      const SilhouetteTerms& silhouettes,
                      const VoxelTerms& terms);

  LevelInputs inputs_;
  LevelSummary& summary_;
};

}  // namespace octacut
