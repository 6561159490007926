#include "core/pipeline/deepen_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "core/crust/crust.h"
#include "core/crust/medial_voxels.h"
#include "core/evidence/finer_depths.h"
#include "core/pipeline/level_step.h"

namespace octacut {
namespace {

// Evidence for the present surface where finer depths say nothing, units of the
// weights.
constexpr float kPresentWeight = 0.03f;
// What counts of finer depths beside photo-consistency: free space, so that no
// fold closes again. Their matter would push the surface outward by as much as
// depths are too near beside contours.
constexpr float kFreeSpaceShare = 0.3f;

// The first cut of `crust` is by evidence alone, as that of l0; where there is
// none the present surface, which crust.prior holds, is the best guess.
std::vector<FaceLabels> CutByFinerDepths(const LevelInputs& inputs,
                                         const Crust& crust,
                                         const std::vector<float>& finer,
                                         const SilhouetteTerms& silhouettes,
                                         LevelSteps* steps) {
  CutTerms terms{
      std::vector<float>(crust.voxels.Size(), NeutralWeight(inputs.options)),
      finer};
  for (size_t i = 0; i < terms.evidence.size(); ++i) {
    if (terms.evidence[i] == 0) {
      terms.evidence[i] = kPresentWeight * (2 * crust.prior[i] - 1);
    }
  }
  OctahedralCutState state;
  OctahedralCut cut = steps->Cut(crust, terms, &state);
  steps->CoverSilhouettes(
      crust, {{}, silhouettes.hull_depth}, &terms, &state, &cut);
  return std::move(cut.labels);
}

}  // namespace

SolvedLevel DeepenLevel(const LevelInputs& inputs,
                        const LabelHierarchy& hierarchy,
                        SolvedLevel solved,
                        LevelSummary* summary) {
  const LabeledVoxels& present = solved.surface;
  LevelSteps steps(inputs, present.voxels.Level(), summary);
  const FinerEvidence finer = steps.OnCrust([&] {
    return FindFinerDepths(inputs.views,
                           present,
                           inputs.evidence.depth_confidence,
                           inputs.options.evidence,
                           inputs.context);
  });
  if (finer.voxels.Empty()) {
    return solved;
  }
  inputs.context.Info(
      fmt::format("Level {}: the finer depth sweep found depths below the "
                  "surface, so the crust is enlarged from {} to {} voxels.",
                  present.voxels.Level(),
                  present.voxels.Size(),
                  finer.voxels.Size()));
  Crust crust = steps.OnCrust([&] {
    return WidenCrust(hierarchy, present, finer.voxels, inputs.context);
  });
  const SilhouetteTerms silhouettes = steps.EstimateSilhouettes(crust.voxels);
  const std::vector<FaceLabels> first =
      CutByFinerDepths(inputs, crust, finer.values, silhouettes, &steps);
  steps.OnCrust(
      [&] { AdoptCut(first, kMinMedialDepth, inputs.context, &crust); });
  std::vector<float> free_space = finer.values;
  for (float& value : free_space) {
    value = kFreeSpaceShare * std::min(value, 0.0f);
  }
  return CutByPhotographs(
      std::move(crust), first, free_space, silhouettes, &steps);
}

}  // namespace octacut
