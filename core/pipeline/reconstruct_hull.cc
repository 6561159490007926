#include "core/pipeline/reconstruct_hull.h"

#include "core/hull/hull_surface.h"
#include "core/pipeline/prepare_scene.h"

namespace octacut {

void HullReconstructionOptions::Check() const {
  hull.Check();
  finish.Check();
}

HullReconstruction ReconstructHull(const Scene& scene,
                                   const Region& region,
                                   const HullReconstructionOptions& options,
                                   const Context& context) {
  options.Check();
  CheckScene(scene, false);
  CheckFloatsResolve(region.cube, options.hull.hull_level);
  const PreparedScene prepared =
      PrepareScene(scene,
                   region.cube,
                   {.mask_tolerance = 0,
                    .fill_false_gaps = options.fill_false_gaps,
                    .move_mask_borders = false},
                   context);
  const ViewSet& views = prepared.views;
  const LabeledVoxels surface = ComputeHullSurface(
      views, region.cube.ToUnit(region.box), options.hull, context);
  const FinishedMesh finished =
      FinalMesh(views, surface, region.cube, options.finish, context);
  HullReconstruction result;
  result.mesh = ToSurfaceMesh(finished.mesh);
  result.audit = AuditMesh(finished.mesh, context);
  CheckAudit(result.audit);
  result.verdict = JudgeMesh(
      finished.mesh,
      finished.removed,
      {scene.views, prepared.repaired.scene.views, views, region.cube},
      JudgeOptions(),
      context);
  return result;
}

}  // namespace octacut
