#include "core/pipeline/reconstruct.h"

#include <algorithm>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/evidence/trim_hull.h"
#include "core/hull/hull_surface.h"
#include "core/pipeline/build_mesh.h"
#include "core/pipeline/color_mesh.h"
#include "core/pipeline/finish_mesh.h"
#include "core/pipeline/judge_dents.h"
#include "core/pipeline/level_step.h"
#include "core/pipeline/prepare_scene.h"
#include "core/pipeline/run_step.h"
#include "core/pipeline/shown_surface.h"
#include "core/scene/surface_area.h"
#include "core/views/view_set.h"

namespace octacut {
namespace {

void CheckInput(const Scene& scene,
                const Region& region,
                const ReconstructionOptions& options) {
  options.Check();
  CheckScene(scene, true);
  CheckFloatsResolve(region.cube, options.target_level);
}

PreparedScene Prepare(const Scene& scene,
                      const Region& region,
                      const ReconstructionOptions& options,
                      const Context& context,
                      ReconstructionSummary* summary) {
  return RunStep(context, "preparation", &summary->prepare_seconds, [&] {
    PreparedScene prepared =
        PrepareScene(scene, region.cube, options.masks, context);
    summary->num_false_gaps = prepared.repaired.gaps.size();
    for (size_t i = 0; i < scene.views.size(); ++i) {
      if (prepared.moved_inwards[i] != 0) {
        summary->moved_masks[scene.views[i].name] = prepared.moved_inwards[i];
      }
    }
    summary->border_edges = prepared.border_edges;
    return prepared;
  });
}

struct Hull {
  VoxelGrid voxels;
  LabeledVoxels surface;
};

Hull CarveHull(const ViewSet& views,
               const Region& region,
               const ReconstructionOptions& options,
               const Context& context,
               ReconstructionSummary* summary) {
  return RunStep(context, "visual hull", &summary->hull_seconds, [&] {
    const Eigen::AlignedBox3f box = region.cube.ToUnit(region.box);
    const HullOctree octree =
        RefineHull(views, box, options.hull.hull_level, context);
    VisualHull hull = ComputeVisualHull(octree);
    summary->hull = std::move(hull.summary);
    return Hull{std::move(hull.voxels),
                ComputeHullSurface(views, box, octree, context)};
  });
}

// Solves l0 on trial. Where that cut lies inside of the hull, the confidence in
// the evidence becomes what the views say of the cut itself.
void DoubtDents(const ViewSet& views,
                const VoxelGrid& hull,
                const LabeledVoxels& hull_surface,
                const ReconstructionOptions& options,
                const Context& context,
                InsideEvidence* evidence) {
  if (evidence->depths.scene_confidence == 0) {
    return;  // without confidence in depths, the cut stays at the hull
  }
  LevelSummary trial_summary;
  const LabeledVoxels trial =
      SolveInitialLevel(
          {views, *evidence, options, context}, hull, &trial_summary)
          .surface;
  ReviseEvidence(views,
                 hull,
                 JudgeDents(views,
                            hull_surface,
                            trial,
                            evidence->depths.maps,
                            options.refinement,
                            context),
                 options.evidence,
                 context,
                 evidence);
}

// Trims the hull by the masks that can be relied upon, too.
InsideEvidence EstimateEvidence(const ViewSet& views,
                                const LabeledVoxels& hull_surface,
                                const ReconstructionOptions& options,
                                const Context& context,
                                VoxelGrid* hull,
                                ReconstructionSummary* summary) {
  InsideEvidence evidence =
      RunStep(context, "depths and evidence", &summary->evidence_seconds, [&] {
        const ShownSurface shown = MeasureShownSurface(
            views, hull_surface, options.refinement, context);
        summary->hull_agreement = shown.agreement;
        InsideEvidence found = EstimateInsideEvidence(
            views, *hull, options.evidence, shown.share, context);
        *hull = TrimHull(views, *hull, context, &found);
        DoubtDents(views, *hull, hull_surface, options, context, &found);
        found.depths = {};  // nothing reads them any more
        return found;
      });
  summary->hull.num_voxels = hull->Size();
  summary->evidence = evidence.summary;
  return evidence;
}

MeshVerdict Judge(const FinishedMesh& finished,
                  const JudgedScene& scene,
                  const std::vector<double>& moved_inwards,
                  const ReconstructionOptions& options,
                  const Context& context,
                  const ReconstructionSummary& summary) {
  return JudgeMesh(
      finished.mesh,
      finished.removed,
      scene,
      {.mask_tolerance = options.masks.mask_tolerance,
       .border_shift = summary.refinement ? summary.refinement->border_shift
                                          : scene.views.front().border_shift,
       .moved_inwards = moved_inwards,
       .hull_level = options.hull.hull_level,
       .refinement = options.refinement,
       .confidence = options.confidence},
      context);
}

}  // namespace

Reconstruction Reconstruct(const Scene& scene,
                           const Region& region,
                           const ReconstructionOptions& options,
                           const Context& context,
                           const LevelObserver& observer) {
  CheckInput(scene, region, options);
  Reconstruction result;
  ReconstructionSummary& summary = result.summary;

  PreparedScene prepared = Prepare(scene, region, options, context, &summary);
  ViewSet& views = prepared.views;
  Hull hull = CarveHull(views, region, options, context, &summary);
  if (observer) {
    observer(-1, PositionedMesh(hull.surface, region.cube, context));
  }
  const InsideEvidence evidence = EstimateEvidence(
      views, hull.surface, options, context, &hull.voxels, &summary);

  BuiltMesh built = BuildMesh(
      {hull.voxels, evidence, region.cube, options, context, observer},
      &views,
      &summary);
  FinishedMesh& finished = built.finished;
  result.mesh = Timed(&summary.coloring_seconds, [&] {
    return ColoredMesh(finished.mesh,
                       views,
                       built.surface,
                       region.cube,
                       options.visibility,
                       context);
  });

  finished.mesh = ToIndexedMesh(result.mesh);
  result.audit = AuditMesh(finished.mesh, context);
  CheckAudit(result.audit);
  result.verdict =
      Judge(finished,
            {scene.views, prepared.repaired.scene.views, views, region.cube},
            prepared.moved_inwards,
            options,
            context,
            summary);
  return result;
}

size_t EstimateReconstructionBytes(const Scene& scene,
                                   const BoundingCube& cube,
                                   const ReconstructionOptions& options,
                                   const Context& context) {
  const double area = EstimateSurfaceArea(scene.views, cube);
  const size_t refinement_bytes =
      options.refine ? EstimateRefinementBytes(
                           EstimateVertices(options.target_level, area))
                     : 0;
  return EstimateViewBytes(scene) +
         std::max({EstimateLevelBytes(area, options),
                   refinement_bytes,
                   EstimateSweepBytes(
                       scene.views.size(), options.hull.hull_level, context)});
}

}  // namespace octacut
