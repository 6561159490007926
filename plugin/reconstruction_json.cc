#include "plugin/reconstruction_json.h"

#include "plugin/refinement_options.h"

namespace octacut {
namespace {

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
          {"moved_masks", summary.moved_masks},
          {"border_edges", BorderEdgesToJson(summary.border_edges)},
          {"evidence",
           {{"depths", summary.evidence.num_depths},
            {"agreeing_depths", summary.evidence.num_agreeing},
            {"plausible_depths", summary.evidence.num_plausible},
            {"free_voxels", summary.evidence.num_free_voxels},
            {"contradicted_depths", summary.evidence.contradicted_share},
            {"hull_agreement", summary.hull_agreement},
            {"found_depths", summary.evidence.found_share},
            {"seconds", summary.evidence_seconds}}},
          {"levels", levels},
          {"recuts",
           {{"kept", summary.recuts.num_kept},
            {"moved_shares", summary.recuts.moved},
            {"agreements", summary.recuts.agreements},
            {"seconds", summary.recuts.seconds}}},
          {"meshing",
           {{"polygons", summary.finish.extraction.num_polygons},
            {"four_polygon_edges",
             summary.finish.extraction.num_four_polygon_edges},
            {"split_vertices", summary.finish.extraction.num_split_vertices},
            {"fans", summary.finish.extraction.num_fans},
            {"removed_components", summary.finish.num_removed_components},
            {"vertices_moved_to_hull", summary.num_moved_to_hull},
            {"removed_handles", summary.finish.handles.num_removed},
            {"refused_handle_loops", summary.finish.handles.num_refused},
            {"seconds", summary.meshing_seconds}}},
          {"refinement",
           summary.refinement ? RefinementToJson(*summary.refinement) : Json()},
          {"prepare_seconds", summary.prepare_seconds},
          {"coloring_seconds", summary.coloring_seconds}};
}

}  // namespace octacut
