#include "core/pipeline/reconstruct.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/base/check_option.h"
#include "core/base/stopwatch.h"
#include "core/crust/label_hierarchy.h"
#include "core/evidence/trim_hull.h"
#include "core/hull/false_gaps.h"
#include "core/hull/hull_surface.h"
#include "core/pipeline/deepen_level.h"
#include "core/pipeline/finish_mesh.h"
#include "core/pipeline/level_step.h"
#include "core/views/border_edges.h"
#include "core/views/view_set.h"

namespace octacut {
namespace {

void CheckScene(const Scene& scene, bool needs_images) {
  if (scene.views.size() < 3) {
    throw InputError(fmt::format("{} views are too few: at least 3 are needed",
                                 scene.views.size()));
  }
  // Lists of views that see a place hold numbers of 16 bits.
  if (scene.views.size() > std::numeric_limits<uint16_t>::max()) {
    throw InputError(
        fmt::format("{} views are too many: at most {} can be used",
                    scene.views.size(),
                    std::numeric_limits<uint16_t>::max()));
  }
  for (const View& view : scene.views) {
    if ((needs_images && view.image.empty()) || view.mask.empty()) {
      throw InputError(view.name + ": the view has no image or no mask");
    }
  }
}

Eigen::AlignedBox3f BoxInUnitCoordinates(const Region& region) {
  const auto to_unit = [&](const Eigen::Vector3d& x) {
    return Eigen::Vector3f(
        ((x - region.cube.min_corner) / region.cube.edge).cast<float>());
  };
  return {to_unit(region.box.min()), to_unit(region.box.max())};
}

void ReportLevel(const LevelSummary& level, const Context& context) {
  context.Info(
      fmt::format("Level {} ({}^3 voxels): {} voxels in the crust, {} in the "
                  "cut, cost {:.6g}.",
                  level.level,
                  level.resolution,
                  level.num_crust_voxels,
                  level.num_cut_voxels,
                  level.cut_cost));
  if (level.num_border_voxels > 0) {
    context.Warn(fmt::format(
        "Level {}: {} voxels of the cut still touch the border of the crust "
        "after it was enlarged {} times. The surface may be inaccurate there; "
        "a higher --OctahedralMeshing.max_grow_rounds may help.",
        level.level,
        level.num_border_voxels,
        level.num_grow_rounds));
  }
}

}  // namespace

Reconstruction Reconstruct(const Scene& scene,
                           const Region& region,
                           const ReconstructionOptions& options,
                           const Context& context,
                           const LevelObserver& observer) {
  options.Check();
  CheckScene(scene, true);
  CheckFloatsResolve(region.cube, options.target_level);
  Reconstruction result;
  ReconstructionSummary& summary = result.summary;
  Stopwatch stopwatch;
  const RepairedScene repaired = RepairMasks(scene,
                                             region.cube,
                                             options.mask_tolerance,
                                             options.fill_false_gaps,
                                             context);
  summary.num_false_gaps = repaired.gaps.size();
  ViewSet views = PrepareViews(
      repaired.scene, region.cube, context, options.mask_tolerance);
  summary.border_edges = ShiftBordersToEdges(context, &views);
  const Eigen::AlignedBox3f box = BoxInUnitCoordinates(region);
  summary.prepare_seconds = stopwatch.Lap();

  VisualHull hull = ComputeVisualHull(views, box, options.hull, context);
  summary.hull = hull.summary;
  summary.hull_seconds = stopwatch.Lap();
  if (observer) {
    observer(
        -1,
        PositionedMesh(ComputeHullSurface(views, box, options.hull, context),
                       region.cube,
                       context));
    stopwatch.Lap();
  }

  InsideEvidence evidence =
      EstimateInsideEvidence(views, hull.voxels, options.evidence, context);
  hull.voxels = TrimHull(views, hull.voxels, context, &evidence);
  summary.hull.num_voxels = hull.voxels.Size();
  summary.evidence = evidence.summary;
  summary.evidence_seconds = stopwatch.Lap();

  LabelHierarchy hierarchy;
  for (int level = options.hull.hull_level; level <= options.target_level;
       ++level) {
    LevelSummary& step = summary.levels.emplace_back();
    LabeledVoxels solved =
        hierarchy.Empty()
            ? SolveInitialLevel(
                  views, hull.voxels, evidence, options, context, &step)
            : SolveFinerLevel(
                  views, evidence, hierarchy, options, context, &step);
    if (level == options.hull.hull_level + 1) {
      solved = DeepenLevel(views,
                           evidence,
                           hierarchy,
                           std::move(solved),
                           options,
                           context,
                           &step);
    }
    hierarchy.Add(std::move(solved));
    ReportLevel(step, context);
    if (observer) {
      observer(level, PositionedMesh(hierarchy.Finest(), region.cube, context));
    }
  }

  stopwatch.Lap();
  auto [mesh, removed] = FinalMesh(
      views, hierarchy.Finest(), region.cube, options, context, &summary);
  summary.meshing_seconds = stopwatch.Lap();
  if (options.refine) {
    RefinedSurface refined = RefineSurface(
        std::move(mesh), region.cube, options.refinement, context, &views);
    mesh = std::move(refined.mesh);
    summary.refinement = std::move(refined.summary);
    stopwatch.Lap();
  }
  result.mesh = ToSurfaceMesh(mesh);
  ColorMesh(views,
            hierarchy.Finest(),
            region.cube,
            options.visibility,
            context,
            &result.mesh);
  summary.coloring_seconds = stopwatch.Lap();
  result.audit = AuditMesh(ToIndexedMesh(result.mesh), context);
  CheckAudit(result.audit);
  result.verdict = JudgeMesh(
      ToIndexedMesh(result.mesh),
      removed,
      {scene.views, repaired.scene.views, views, region.cube},
      {.mask_tolerance = options.mask_tolerance,
       .border_shift = summary.refinement ? summary.refinement->border_shift
                                          : views.front().border_shift,
       .hull_level = options.hull.hull_level,
       .refinement = options.refinement,
       .confidence = options.confidence},
      context);
  return result;
}

HullReconstruction ReconstructHull(const Scene& scene,
                                   const Region& region,
                                   const HullReconstructionOptions& options,
                                   const Context& context) {
  options.Check();
  CheckScene(scene, false);
  CheckFloatsResolve(region.cube, options.hull.hull_level);
  const RepairedScene repaired =
      RepairMasks(scene, region.cube, 0, options.fill_false_gaps, context);
  const ViewSet views = PrepareViews(repaired.scene, region.cube, context);
  const LabeledVoxels surface = ComputeHullSurface(
      views, BoxInUnitCoordinates(region), options.hull, context);
  ReconstructionOptions finishing;
  finishing.smoothing = options.smoothing;
  ReconstructionSummary summary;
  const FinishedMesh finished =
      FinalMesh(views, surface, region.cube, finishing, context, &summary);
  HullReconstruction result;
  result.mesh = ToSurfaceMesh(finished.mesh);
  result.audit = AuditMesh(finished.mesh, context);
  CheckAudit(result.audit);
  result.verdict =
      JudgeMesh(finished.mesh,
                finished.removed,
                {scene.views, repaired.scene.views, views, region.cube},
                JudgeOptions(),
                context);
  return result;
}

namespace {

// Of the depth sweep: a reduced view and its depths, 20 bytes a sample, and
// scores of all planes for each of the threads.
size_t EstimateSweepBytes(size_t num_views,
                          const ReconstructionOptions& options,
                          const Context& context) {
  const double resolution = double(1u << options.hull.hull_level);
  const DepthSweepOptions& sweep = options.evidence.sweep;
  const double side = resolution * sweep.samples_per_voxel;
  const double num_planes = resolution * sweep.planes_per_voxel;
  return size_t(side * side *
                (20 * double(num_views) +
                 num_planes * sizeof(float) * context.NumThreads()));
}

}  // namespace

size_t EstimateReconstructionBytes(const Scene& scene,
                                   const ReconstructionOptions& options,
                                   const Context& context) {
  // A crust is a band around a surface that in a tight cube has some 2.5
  // times the area of one of its sides.
  constexpr double kSurfaceShare = 2.5;
  const double resolution = double(1u << options.target_level);
  const double thickness = 2 + 2 * options.crust.crust_dilation;
  const size_t num_voxels =
      size_t(kSurfaceShare * resolution * resolution * thickness);
  // Grid, ties, prior, phi, weights, evidence, normals and depth maps. The
  // state of a cut is there beside them while its crust may grow.
  constexpr size_t kStepBytesPerVoxel = 48;
  const size_t level_bytes =
      num_voxels * kStepBytesPerVoxel +
      EstimateOctahedralCutBytes(num_voxels, true, options.cut.lean);
  // Mesh, boxes, rays, places and their equations, as measured.
  constexpr size_t kRefinementBytesPerVertex = 700;
  const size_t refinement_bytes =
      options.refine ? size_t(kSurfaceShare * resolution * resolution) *
                           kRefinementBytesPerVertex
                     : 0;
  size_t view_bytes = 0;
  for (const View& view : scene.views) {
    // Pyramid (4 bytes a pixel and a third), summed areas and distances.
    view_bytes += view.mask.total() * 12;
  }
  return view_bytes +
         std::max({level_bytes,
                   refinement_bytes,
                   EstimateSweepBytes(scene.views.size(), options, context)});
}

}  // namespace octacut
