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
          {"validity_seconds", round.validity_seconds}};
}

}  // namespace

void DeclareRefinementOptions(OptionManager& options,
                              RefineOptions* refinement) {
  options.Add("Refinement.fine_rounds",
              &refinement->fine_rounds,
              "Rounds at the scale of the images");
  options.Add("Refinement.coarse_rounds",
              &refinement->coarse_rounds,
              "Rounds before, each at half the resolution of the next");
  options.Add("Refinement.coarse_passes",
              &refinement->coarse_passes,
              "How often the coarse rounds are run");
  options.Add("Refinement.range",
              &refinement->range,
              "Search along the normal in the first round of a scale, pixels "
              "of that scale. All pixels of refinement are those of the "
              "photographs as the target level holds them");
  options.Add("Refinement.alignment_steps",
              &refinement->alignment_steps,
              "By which the views' poses are aligned in the last round of each "
              "coarse pass but the first, and each one at their scale; 0: they "
              "are exact");
  options.Add("Refinement.step", &refinement->step, "Of the search, pixels");
  options.Add("Refinement.patch_radius",
              &refinement->patch.radius,
              "Of the patch of (2 r + 1)^2 samples, pixels");
  options.Add("Refinement.measure_spacing",
              &refinement->measure_spacing,
              "Between the places that are measured, pixels");
  options.Add("Refinement.fit_radius",
              &refinement->fit_radius,
              "Of the pieces of the surface that count as smooth, pixels");
  options.Add("Refinement.smoothness",
              &refinement->smoothness,
              "Weight of the surface's bend");
  options.Add("Refinement.silhouette_weight",
              &refinement->silhouette_weight,
              "Weight of the masks' borders; 0: none");
  options.Add("Refinement.border_noise",
              &refinement->border_noise,
              "Pixels to which photographs tell a shift of all masks' borders; "
              "large (1000): masks are right");
  options.Add("Refinement.hull_tolerance",
              &refinement->hull_tolerance,
              "Pixels by which the surface may leave a silhouette, besides "
              "those by which masks are found to be too small");
  options.Add("Refinement.pixel_noise",
              &refinement->patch.pixel_noise,
              "Grey levels; weaker contrast of a patch counts less");
  options.Add("Refinement.hue_weight",
              &refinement->patch.hue_weight,
              "Of differences of hue against those of grey, to which gloss "
              "adds");
  options.Add("Refinement.min_score",
              &refinement->min_score,
              "Least agreement of the views about an offset");
  options.Add("Refinement.max_views",
              &refinement->views.max_views,
              "Views of a place at most");
  options.Add("Refinement.max_angle",
              &refinement->views.max_angle,
              "Of a view to the normal, degrees");
  options.Add("Refinement.min_separation",
              &refinement->views.min_separation,
              "Between the directions of two views of a place, degrees");
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
