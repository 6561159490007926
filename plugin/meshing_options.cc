#include "plugin/meshing_options.h"

#include "plugin/refinement_options.h"
#include "plugin/workspace_options.h"

namespace octacut {
namespace {

void DeclareEvidenceOptions(OptionManager& options,
                            InsideEvidenceOptions* evidence) {
  options.Add("OctahedralMeshing.ballooning",
              &evidence->ballooning,
              "Bias towards the inside for voxels of the visual hull that no "
              "view decides. Lower values open deeper concavities, higher "
              "values keep more of untextured objects.");
  options.Add("OctahedralMeshing.matter_weight",
              &evidence->matter_weight,
              "Weight of the evidence for the inside that one view gives to a "
              "voxel just behind a surface it has found.");
  options.Add("OctahedralMeshing.free_space_weight",
              &evidence->free_space_weight,
              "Weight of the evidence for the outside that one view gives to a "
              "voxel it sees through.");
  options.Add(
      "OctahedralMeshing.cover_weight",
      &evidence->cover_weight,
      "Weight of the evidence for the inside that an uncovered object pixel "
      "gives to the voxels on its ray together; doubled each round.");
  options.Add(
      "OctahedralMeshing.cover_rounds",
      &evidence->cover_rounds,
      "Maximum number of rounds that restore uncovered object pixels on the "
      "first level, 0 to 8; 0 restores none on any level.");
  options.Add("OctahedralMeshing.min_agreeing_views",
              &evidence->min_agreeing_views,
              "Number of other views that must confirm a depth; see "
              "min_like_samples for exceptions.");
  options.Add(
      "OctahedralMeshing.min_like_samples",
      &evidence->min_like_samples,
      "If fewer views confirm a depth, but at least one does, this many of its "
      "eight neighbouring samples must share it; 9 rejects all such depths.");
  options.Add(
      "DepthSweep.num_neighbors",
      &evidence->sweep.num_neighbors,
      "Number of neighbouring views that each view is compared with, 2 to 8.");
  options.Add(
      "DepthSweep.min_angle",
      &evidence->sweep.min_angle,
      "Minimum angle between the directions of neighbouring views in degrees.");
  options.Add(
      "DepthSweep.max_angle",
      &evidence->sweep.max_angle,
      "Maximum angle between the directions of neighbouring views in degrees.");
  options.Add("DepthSweep.samples_per_voxel",
              &evidence->sweep.samples_per_voxel,
              "Number of image samples across a voxel of the visual hull.");
  options.Add("DepthSweep.planes_per_voxel",
              &evidence->sweep.planes_per_voxel,
              "Number of depth planes across a voxel of the visual hull.");
  options.Add("DepthSweep.window_radius",
              &evidence->sweep.window_radius,
              "Radius of the correlation window in samples.");
  options.Add("DepthSweep.min_score",
              &evidence->sweep.min_score,
              "Minimum correlation at which a depth is accepted, 0 to 1.");
}

void DeclareConsistencyOptions(OptionManager& options,
                               ReconstructionOptions* meshing) {
  options.AddEnum(
      "OctahedralMeshing.consistency",
      &meshing->consistency.measure,
      {{"normalized_variance", ConsistencyMeasure::kNormalizedVariance},
       {"ncc", ConsistencyMeasure::kNcc},
       {"variance", ConsistencyMeasure::kVariance}},
      "Photo-consistency measure: colour variance normalised per image, "
      "pairwise correlation, or plain colour variance.");
  options.Add("OctahedralMeshing.patch_radius",
              &meshing->consistency.patch_radius,
              "Radius r in voxels of the patch of (2 r + 1)^2 samples that "
              "photo-consistency compares, 1 to 4.");
  options.Add("OctahedralMeshing.min_patch_pixels",
              &meshing->consistency.min_patch_pixels,
              "Minimum size of the patch in pixels. If voxels are small, the "
              "patch radius grows up to 4 to reach it.");
  options.Add("OctahedralMeshing.neutral",
              &meshing->consistency.neutral,
              "Photo-consistency, from 0 (consistent) to 1, of voxels that "
              "fewer than two views see.");
  options.Add("OctahedralMeshing.pixel_noise",
              &meshing->consistency.pixel_noise,
              "Standard deviation of the image noise in grey levels (0 to "
              "255). Patches with less contrast count as untextured.");
  options.Add("OctahedralMeshing.hue_weight",
              &meshing->consistency.hue_weight,
              "Chroma weight: weight of colour differences relative to "
              "brightness differences, 0 to 8. Raise it for shiny paint.");
  options.Add("OctahedralMeshing.max_views",
              &meshing->visibility.max_views,
              "Maximum number of views that are compared for a voxel.");
  options.Add(
      "OctahedralMeshing.max_angle",
      &meshing->visibility.max_angle,
      "Maximum angle in degrees between viewing direction and surface normal.");
  options.Add("OctahedralMeshing.depth_tolerance",
              &meshing->visibility.depth_tolerance,
              "Distance in voxels behind the surface up to which a voxel "
              "counts as visible.");
  options.Add("OctahedralMeshing.normal_blur",
              &meshing->normal_blur,
              "Number of times the inside of the surface is averaged before "
              "normals are estimated, 1 to 64.");
}

Json LevelToJson(const LevelSummary& level) {
  return {{"level", level.level},
          {"resolution", level.resolution},
          {"crust_voxels", level.num_crust_voxels},
          {"medial_voxels", level.num_medial_voxels},
          {"graph_nodes", level.num_graph_nodes},
          {"cut_voxels", level.num_cut_voxels},
          {"cut_cost", level.cut_cost},
          {"mean_consistency", level.consistency.mean},
          {"unseen_voxels", level.consistency.num_unseen},
          {"decided_by_photographs", level.decided_share},
          {"grow_rounds", level.num_grow_rounds},
          {"cover_rounds", level.num_cover_rounds},
          {"silhouettes_missed_before", level.missed_before},
          {"silhouettes_missed", level.missed_after},
          {"cover_voxels", level.num_cover_voxels},
          {"border_voxels", level.num_border_voxels},
          {"crust_seconds", level.crust_seconds},
          {"visibility_seconds", level.visibility_seconds},
          {"consistency_seconds", level.consistency_seconds},
          {"cut_seconds", level.cut_seconds},
          {"cover_seconds", level.cover_seconds}};
}

}  // namespace

void DeclareMeshingOptions(OptionManager& options,
                           ReconstructionOptions* meshing) {
  options.Add("OctahedralMeshing.hull_level",
              &meshing->hull.hull_level,
              "Level of the visual hull, which has (2^level)^3 voxels. Raise "
              "it for structures thinner than three of its voxels.");
  DeclareMaskTolerance(options, &meshing->mask_tolerance);
  DeclareFillFalseGaps(options, &meshing->fill_false_gaps);
  options.Add(
      "OctahedralMeshing.target_level",
      &meshing->target_level,
      "Level of the result, which is cut from (2^level)^3 voxels. Choose it so "
      "that a voxel is about as large as a pixel on the object.");
  options.Add("OctahedralMeshing.crust_dilation",
              &meshing->crust.crust_dilation,
              "Number of dilations that turn the surface of a level into the "
              "crust of the next one (d in the paper).");
  options.Add("OctahedralMeshing.smoothness",
              &meshing->energy.smoothness,
              "Exponent s of the edge weights phi^s + a, where phi is the "
              "photo-consistency.");
  options.Add("OctahedralMeshing.area_weight",
              &meshing->energy.area_weight,
              "Constant a of the edge weights phi^s + a. Higher values prefer "
              "surfaces of smaller area.");
  options.Add("OctahedralMeshing.silhouette_weight",
              &meshing->energy.silhouette_weight,
              "Weight of the evidence for the outside of voxels that are "
              "background in at least one view.");
  options.Add("OctahedralMeshing.mask_border_weight",
              &meshing->energy.mask_border_weight,
              "Weight of the evidence for the outside of background voxels "
              "within mask_tolerance of the object, at the first level and for "
              "masks that depths confirm.");
  options.Add("OctahedralMeshing.unseen_weight",
              &meshing->energy.unseen_weight,
              "Weight of the evidence for the inside of voxels that fewer than "
              "two views see, at the first level; halved at each finer level.");
  options.Add("OctahedralMeshing.max_grow_rounds",
              &meshing->max_grow_rounds,
              "Maximum number of times a crust is enlarged because the cut "
              "touches its border, 0 to 16.");
  options.Add(
      "OctahedralMeshing.lean_cut",
      &meshing->cut.lean,
      "If 1, cut with 14-bit weights, which needs a third less memory.");
  DeclareConsistencyOptions(options, meshing);
  DeclareEvidenceOptions(options, &meshing->evidence);
  options.Add("OctahedralMeshing.min_component",
              &meshing->min_component,
              "Remove components with less than this share of the largest "
              "component's volume, except those that the masks of two or more "
              "images require.");
  options.Add(
      "OctahedralMeshing.min_handle",
      &meshing->min_handle,
      "Remove handles and pinholes that a loop of at most this many voxels (or "
      "pixels, if these are larger) encircles; 0 keeps all.");
  options.Add("Smoothing.iterations",
              &meshing->smoothing.iterations,
              "Number of smoothing iterations V <- V + lambda Laplacian(V).");
  options.Add("Smoothing.lambda",
              &meshing->smoothing.lambda,
              "Step size lambda of smoothing, 0 to 1.");
  options.Add(
      "Smoothing.taubin_mu",
      &meshing->smoothing.taubin_mu,
      "Step size mu of the inverse step after each iteration, which restores "
      "the volume (Taubin smoothing); at most -lambda, or 0 for none.");
  options.Add("Smoothing.max_displacement",
              &meshing->smoothing.max_displacement,
              "Maximum distance in voxels by which smoothing moves a vertex.");
  options.Add(
      "OctahedralMeshing.refine",
      &meshing->refine,
      "If 1, refine the mesh and the poses photometrically below voxel size.");
  DeclareRefinementOptions(options, &meshing->refinement);
}

namespace {

Json BorderEdgesToJson(const std::optional<BorderEdges>& edges) {
  if (!edges) {
    return Json();
  }
  return {{"shift", edges->shift},
          {"deviation", edges->deviation},
          {"share", edges->share}};
}

}  // namespace

Json ReconstructionToJson(const ReconstructionSummary& summary) {
  Json levels = Json::array();
  for (const LevelSummary& level : summary.levels) {
    levels.push_back(LevelToJson(level));
  }
  return {{"hull",
           {{"filled_mask_gaps", summary.num_false_gaps},
            {"voxels", summary.hull.num_voxels},
            {"tested_voxels", summary.hull.tested_voxels},
            {"seconds", summary.hull_seconds}}},
          {"border_edges", BorderEdgesToJson(summary.border_edges)},
          {"evidence",
           {{"depths", summary.evidence.num_depths},
            {"agreeing_depths", summary.evidence.num_agreeing},
            {"plausible_depths", summary.evidence.num_plausible},
            {"free_voxels", summary.evidence.num_free_voxels},
            {"contradicted_depths", summary.evidence.contradicted_share},
            {"found_depths", summary.evidence.found_share},
            {"seconds", summary.evidence_seconds}}},
          {"levels", levels},
          {"meshing",
           {{"polygons", summary.extraction.num_polygons},
            {"four_polygon_edges", summary.extraction.num_four_polygon_edges},
            {"split_vertices", summary.extraction.num_split_vertices},
            {"fans", summary.extraction.num_fans},
            {"removed_components", summary.num_removed_components},
            {"removed_handles", summary.handles.num_removed},
            {"refused_handle_loops", summary.handles.num_refused},
            {"seconds", summary.meshing_seconds}}},
          {"refinement",
           summary.refinement ? RefinementToJson(*summary.refinement) : Json()},
          {"prepare_seconds", summary.prepare_seconds},
          {"coloring_seconds", summary.coloring_seconds}};
}

}  // namespace octacut
