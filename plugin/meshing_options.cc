#include "plugin/meshing_options.h"

#include "plugin/refinement_options.h"
#include "plugin/workspace_options.h"

namespace octacut {
namespace {

void DeclareEvidenceOptions(OptionManager& options,
                            InsideEvidenceOptions* evidence) {
  options.Add("OctahedralMeshing.ballooning",
              &evidence->ballooning,
              "Evidence for inside of hull voxels that nothing speaks against");
  options.Add("OctahedralMeshing.matter_weight",
              &evidence->matter_weight,
              "Evidence of one view with its surface just before the voxel");
  options.Add("OctahedralMeshing.free_space_weight",
              &evidence->free_space_weight,
              "Evidence of one view that sees through the voxel");
  options.Add("OctahedralMeshing.cover_weight",
              &evidence->cover_weight,
              "Evidence of an object's pixel whose ray is left empty, for all "
              "voxels of the ray together; doubled each round");
  options.Add("OctahedralMeshing.cover_rounds",
              &evidence->cover_rounds,
              "Times at most that what silhouettes miss is asked back");
  options.Add(
      "OctahedralMeshing.min_agreeing_views",
      &evidence->min_agreeing_views,
      "Other views that must confirm a depth; fewer where it is plausible");
  options.Add("OctahedralMeshing.min_like_samples",
              &evidence->min_like_samples,
              "Of the eight samples around a depth that fewer views confirm, "
              "one at least, those that must share it; 9: such depths never "
              "count");
  options.Add("DepthSweep.num_neighbors",
              &evidence->sweep.num_neighbors,
              "Views that each view is compared with");
  options.Add("DepthSweep.min_angle",
              &evidence->sweep.min_angle,
              "Between the directions of such views, degrees");
  options.Add("DepthSweep.max_angle", &evidence->sweep.max_angle, "Degrees");
  options.Add("DepthSweep.samples_per_voxel",
              &evidence->sweep.samples_per_voxel,
              "Samples of a view across a hull voxel");
  options.Add("DepthSweep.planes_per_voxel",
              &evidence->sweep.planes_per_voxel,
              "Depths across a hull voxel");
  options.Add("DepthSweep.window_radius",
              &evidence->sweep.window_radius,
              "Of the correlation window, samples");
  options.Add("DepthSweep.min_score",
              &evidence->sweep.min_score,
              "Least correlation of an accepted depth");
}

void DeclareConsistencyOptions(OptionManager& options,
                               ReconstructionOptions* meshing) {
  options.AddEnum(
      "OctahedralMeshing.consistency",
      &meshing->consistency.measure,
      {{"normalized_variance", ConsistencyMeasure::kNormalizedVariance},
       {"ncc", ConsistencyMeasure::kNcc},
       {"variance", ConsistencyMeasure::kVariance}},
      "Photo-consistency: colour variance normalised per image, "
      "pairwise correlation, plain variance");
  options.Add("OctahedralMeshing.patch_radius",
              &meshing->consistency.patch_radius,
              "Of the patch of (2 r + 1)^2 samples, voxels");
  options.Add(
      "OctahedralMeshing.min_patch_pixels",
      &meshing->consistency.min_patch_pixels,
      "Pixels that a patch spans at least: its radius grows, to 4 at most");
  options.Add("OctahedralMeshing.neutral",
              &meshing->consistency.neutral,
              "Photo-consistency of what fewer than two views see");
  options.Add("OctahedralMeshing.pixel_noise",
              &meshing->consistency.pixel_noise,
              "Grey levels; weaker contrast of a patch counts less");
  options.Add("OctahedralMeshing.hue_weight",
              &meshing->consistency.hue_weight,
              "Of differences of hue against those of grey, to which gloss "
              "adds");
  options.Add("OctahedralMeshing.max_views",
              &meshing->visibility.max_views,
              "Views of a voxel at most");
  options.Add("OctahedralMeshing.max_angle",
              &meshing->visibility.max_angle,
              "Of a view to the normal, degrees");
  options.Add("OctahedralMeshing.depth_tolerance",
              &meshing->visibility.depth_tolerance,
              "Voxels behind the surface that still count as seen");
  options.Add("OctahedralMeshing.normal_blur",
              &meshing->normal_blur,
              "Averagings of the inside before normals are taken");
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
          {"border_voxels", level.num_border_voxels},
          {"crust_seconds", level.crust_seconds},
          {"visibility_seconds", level.visibility_seconds},
          {"consistency_seconds", level.consistency_seconds},
          {"cut_seconds", level.cut_seconds}};
}

}  // namespace

void DeclareMeshingOptions(OptionManager& options,
                           ReconstructionOptions* meshing) {
  options.Add("OctahedralMeshing.hull_level",
              &meshing->hull.hull_level,
              "l0: the visual hull has (2^l0)^3 voxels");
  DeclareMaskTolerance(options, &meshing->mask_tolerance);
  DeclareFillFalseGaps(options, &meshing->fill_false_gaps);
  options.Add("OctahedralMeshing.target_level",
              &meshing->target_level,
              "The mesh is cut from (2^level)^3 voxels");
  options.Add("OctahedralMeshing.crust_dilation",
              &meshing->crust.crust_dilation,
              "d: dilations of the proxy surface");
  options.Add("OctahedralMeshing.smoothness",
              &meshing->energy.smoothness,
              "s: edges weigh phi^s + a");
  options.Add("OctahedralMeshing.area_weight",
              &meshing->energy.area_weight,
              "a: edges weigh phi^s + a");
  options.Add("OctahedralMeshing.silhouette_weight",
              &meshing->energy.silhouette_weight,
              "Evidence for outside of voxels that are background in a view");
  options.Add("OctahedralMeshing.mask_border_weight",
              &meshing->energy.mask_border_weight,
              "The same of voxels within mask_tolerance of the object, at l0, "
              "of masks that depths confirm");
  options.Add("OctahedralMeshing.unseen_weight",
              &meshing->energy.unseen_weight,
              "Evidence for inside of finer voxels that fewer than two views "
              "see, at l0; halved a level");
  options.Add("OctahedralMeshing.max_grow_rounds",
              &meshing->max_grow_rounds,
              "Times that a crust is grown where its cut touches its border");
  options.Add("OctahedralMeshing.lean_cut",
              &meshing->cut.lean,
              "1: cuts with weights of 14 bits, a third less memory");
  DeclareConsistencyOptions(options, meshing);
  DeclareEvidenceOptions(options, &meshing->evidence);
  options.Add("OctahedralMeshing.min_component",
              &meshing->min_component,
              "Components below this share of the largest one's volume go");
  options.Add("OctahedralMeshing.min_handle",
              &meshing->min_handle,
              "Handles go that a loop no longer than so many voxels, or larger "
              "pixels, goes around: bridges are cut, pinholes filled; 0 keeps "
              "all");
  options.Add("Smoothing.iterations",
              &meshing->smoothing.iterations,
              "Of V <- V + lambda Laplacian(V)");
  options.Add("Smoothing.lambda", &meshing->smoothing.lambda, "0 .. 1");
  options.Add("Smoothing.taubin_mu",
              &meshing->smoothing.taubin_mu,
              "Below -lambda: gives back the volume after each iteration");
  options.Add("Smoothing.max_displacement",
              &meshing->smoothing.max_displacement,
              "From where a vertex began, voxels");
  options.Add("OctahedralMeshing.refine",
              &meshing->refine,
              "1: the vertices move to where the photographs agree best");
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
