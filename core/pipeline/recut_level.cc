#include "core/pipeline/recut_level.h"

#include <utility>
#include <vector>

#include "core/crust/crust.h"
#include "core/crust/medial_voxels.h"
#include "core/crust/mesh_labels.h"
#include "core/grid/morphology.h"
#include "core/pipeline/level_step.h"

namespace octacut {

SolvedLevel RecutLevel(const LevelInputs& inputs,
                       const VoxelGrid& hull,
                       const IndexedMesh& mesh,
                       int level,
                       LabelHierarchy* hierarchy,
                       LevelSummary* summary) {
  const Context& context = inputs.context;
  LevelSteps steps(inputs, level, summary);
  LabeledVoxels known;
  const auto around_mesh = [&](int at_level) {
    return Dilate(VoxelsOfMesh(mesh, at_level),
                  inputs.options.crust.HalfWidth(),
                  context);
  };
  Crust crust = steps.OnCrust([&] {
    // The crust may leave the hull, if its level holds what is around.
    *hierarchy = LabelHierarchy();
    hierarchy->Add(
        LabelByMesh(mesh, Union(hull, around_mesh(hull.Level())), context));
    for (int coarser = hull.Level() + 1; coarser < level; ++coarser) {
      hierarchy->Add(LabelByMesh(mesh, around_mesh(coarser), context));
    }
    known = LabelByMesh(mesh, around_mesh(level), context);
    Crust made = WidenCrust(*hierarchy, known, known.voxels, context);
    AdoptCut(known.labels, kMinMedialDepth, context, &made);
    return made;
  });
  const SilhouetteTerms silhouettes = steps.EstimateSilhouettes(crust.voxels);
  return CutByPhotographs(
      std::move(crust), known.labels, {}, silhouettes, &steps);
}

}  // namespace octacut
