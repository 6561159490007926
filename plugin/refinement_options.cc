#include "plugin/refinement_options.h"

namespace octacut {
namespace {

Json RoundToJson(const RoundSummary& round) {
  return {{"scale", round.scale},
          {"range", round.range},
          {"surface_points", round.num_points},
          {"seen_surface_points", round.num_seen},
          {"measured", round.num_measured},
          {"silhouette_targets", round.num_contour_targets},
          {"border_shift", round.border_shift},
          {"mean_displacement", round.mean_displacement},
          {"agreement_seconds", round.agreement_seconds},
          {"look_seconds", round.look_seconds},
          {"aligned_views", round.num_aligned},
          {"alignment_seconds", round.alignment_seconds},
          {"search_seconds", round.search_seconds},
          {"silhouette_seconds", round.silhouette_seconds},
          {"solve_seconds", round.solve_seconds},
          {"taken_back_share", round.taken_back},
          {"withdrawn_vertices", round.num_withdrawn},
          {"hull_tolerance", round.hull_tolerance},
          {"validity_seconds", round.validity_seconds}};
}

}  // namespace

void DeclareRefinementOptions(OptionManager& options,
                              RefineOptions* refinement) {
  options
      .Add("Refinement.alignment_steps",
           &refinement->alignment_steps,
           "Number of iterations that align the camera poses "
           "photometrically; 0 keeps the poses.")
      .ForProjectFiles();
  options
      .Add("Refinement.coarse_passes",
           &refinement->coarse_passes,
           "Number of times that all coarse rounds are run, 1 to 4.")
      .ForProjectFiles();
  // Options of earlier versions. The structs say why each has its value.
  options.AddRemoved("Refinement.border_noise",
                     "--OctahedralMeshing.move_mask_borders 0 leaves the "
                     "borders of the masks where they are");
  options.AddRenamed("Refinement.hue_weight",
                     "OctahedralMeshing.chroma_weight");
  options.AddConstant("Refinement.fine_rounds", RefineOptions::kFineRounds);
  options.AddConstant("Refinement.coarse_rounds", refinement->coarse_rounds);
  options.AddConstant("Refinement.range", RefineOptions::kRange);
  options.AddConstant("Refinement.step", RefineOptions::kStep);
  options.AddConstant("Refinement.patch_radius", refinement->patch.radius);
  options.AddConstant("Refinement.measure_spacing",
                      RefineOptions::kMeasureSpacing);
  options.AddConstant("Refinement.fit_radius", refinement->fit_radius);
  options.AddConstant("Refinement.smoothness", refinement->smoothness);
  options.AddConstant("Refinement.silhouette_weight",
                      RefineOptions::kSilhouetteWeight);
  options.AddRemoved("Refinement.hull_tolerance",
                     "the tolerance is estimated in each round");
  options.AddConstant("Refinement.pixel_noise", PatchOptions::kPixelNoise);
  options.AddConstant("Refinement.min_score", RefineOptions::kMinScore);
  const ViewChoiceOptions& views = refinement->views;
  options.AddConstant("Refinement.max_views", views.max_views);
  options.AddConstant("Refinement.max_angle", views.max_angle);
  options.AddConstant("Refinement.min_separation", views.min_separation);
}

void DeclareChromaWeight(OptionManager& options, double* chroma_weight) {
  options.AddRenamed("OctahedralMeshing.hue_weight",
                     "OctahedralMeshing.chroma_weight");
  options.Add("OctahedralMeshing.chroma_weight",
              chroma_weight,
              "Weight of differences in chroma relative to differences in "
              "brightness, 0 to 8. Raise it for shiny paint.");
}

Json RefinementToJson(const RefineSummary& summary) {
  Json rounds = Json::array();
  for (const RoundSummary& round : summary.rounds) {
    rounds.push_back(RoundToJson(round));
  }
  return {{"pixel_size", summary.pixel_size},
          {"vertices", summary.num_vertices},
          {"moved_vertices", summary.num_moved},
          {"withdrawn_vertices", summary.num_withdrawn},
          {"mean_displacement", summary.mean_displacement},
          {"max_displacement", summary.max_displacement},
          {"border_shift", summary.border_shift},
          {"agreement_before", summary.agreement_before},
          {"agreement_after", summary.agreement_after},
          {"mean_view_motion", summary.view_motion.mean},
          {"max_view_motion", summary.view_motion.max},
          {"rounds", rounds},
          {"seconds", summary.seconds}};
}

}  // namespace octacut
