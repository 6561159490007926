#include "plugin/refinement_options.h"

namespace octacut {
namespace {

Json RoundToJson(const RoundSummary& round) {
  return {{"scale", round.scale},
          {"range", round.range},
          {"places", round.num_places},
          {"seen_places", round.num_seen},
          {"measured", round.num_measured},
          {"silhouette_targets", round.num_rim_targets},
          {"border_shift", round.border_shift},
          {"mean_displacement", round.mean_displacement},
          {"fit_seconds", round.fit_seconds},
          {"view_seconds", round.view_seconds},
          {"aligned_views", round.num_aligned},
          {"alignment_seconds", round.alignment_seconds},
          {"search_seconds", round.search_seconds},
          {"silhouette_seconds", round.silhouette_seconds},
          {"solve_seconds", round.solve_seconds},
          {"withdrawn_vertices", round.num_withdrawn},
          {"hull_tolerance", round.hull_tolerance},
          {"validity_seconds", round.validity_seconds}};
}

}  // namespace

void DeclareRefinementOptions(OptionManager& options,
                              RefineOptions* refinement) {
  options.Add("Refinement.fine_rounds",
              &refinement->fine_rounds,
              "Number of refinement rounds at the full resolution of the "
              "images, 1 to 8.");
  options.Add("Refinement.coarse_rounds",
              &refinement->coarse_rounds,
              "Number of refinement rounds before those, each at half the "
              "resolution of the next one, 0 to 4.");
  options.Add("Refinement.coarse_passes",
              &refinement->coarse_passes,
              "Number of times that all coarse rounds are run, 1 to 4.");
  options.Add(
      "Refinement.range",
      &refinement->range,
      "Search distance along the normal in the first round of a resolution, in "
      "pixels of that resolution. Pixels refer to the images as downsampled "
      "for the target level, here and in all options of this group.");
  options.Add("Refinement.alignment_steps",
              &refinement->alignment_steps,
              "Number of iterations that align the camera poses "
              "photometrically; 0 keeps the poses.");
  options.Add("Refinement.step",
              &refinement->step,
              "Distance in pixels between the offsets that the search tries.");
  options.Add("Refinement.patch_radius",
              &refinement->patch.radius,
              "Radius r in pixels of the patch of (2 r + 1)^2 samples that is "
              "compared between views, 1 to 4.");
  options.Add("Refinement.measure_spacing",
              &refinement->measure_spacing,
              "Distance in pixels between the points of the surface at which "
              "offsets are measured.");
  options.Add("Refinement.fit_radius",
              &refinement->fit_radius,
              "Radius in pixels of the pieces of the surface to which quadrics "
              "are fitted.");
  options.Add("Refinement.smoothness",
              &refinement->smoothness,
              "Weight of the bending energy of the surface relative to a "
              "measured offset. Higher values give a smoother mesh.");
  options.Add("Refinement.silhouette_weight",
              &refinement->silhouette_weight,
              "Weight of the occluding contours, that is, of the masks' "
              "borders, relative to a measured offset; 0 ignores them.");
  options.Add("Refinement.border_noise",
              &refinement->border_noise,
              "Expected error in pixels of the estimate of how much all masks "
              "are too large or too small; 1000 takes the masks as they are.");
  options.Add("Refinement.pixel_noise",
              &refinement->patch.pixel_noise,
              "Standard deviation of the image noise in grey levels (0 to "
              "255). Patches with less contrast count as untextured.");
  options.Add("Refinement.hue_weight",
              &refinement->patch.hue_weight,
              "Chroma weight: weight of colour differences relative to "
              "brightness differences, 0 to 8. Raise it for shiny paint.");
  options.Add(
      "Refinement.min_score",
      &refinement->min_score,
      "Minimum agreement of the views at which an offset is accepted, 0 to 1.");
  options.Add("Refinement.max_views",
              &refinement->views.max_views,
              "Maximum number of views that are compared at a point of the "
              "surface, 2 to 24.");
  options.Add(
      "Refinement.max_angle",
      &refinement->views.max_angle,
      "Maximum angle in degrees between viewing direction and surface normal.");
  options.Add("Refinement.min_separation",
              &refinement->views.min_separation,
              "Minimum angle in degrees between the directions of two views "
              "that are compared.");
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
