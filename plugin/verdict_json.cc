#include "plugin/verdict_json.h"

#include <utility>

namespace octacut {
namespace {

double Share(size_t part, size_t whole) {
  return whole > 0 ? double(part) / double(whole) : 0;
}

Json CountsToJson(const PixelCounts& counts) {
  return {{"object_pixels", counts.object},
          {"border_pixels", counts.border},
          {"covered", Share(counts.covered, counts.object)},
          {"unsure", Share(counts.unsure, counts.object)},
          {"missed", Share(counts.missed, counts.object)},
          {"missed_of_sure", Share(counts.missed, counts.Sure())},
          {"contradicted", Share(counts.contradicted, counts.object)},
          {"exceeded", Share(counts.exceeded, counts.object)},
          {"surely_exceeded", Share(counts.surely_exceeded, counts.object)}};
}

Json MasksToJson(const MaskCheck& check, const std::vector<View>& views) {
  Json each = Json::array();
  for (size_t i = 0; i < views.size(); ++i) {
    Json view = CountsToJson(check.views[i]);
    view["name"] = views[i].name;
    view["denied_pixels_of_others"] = check.denied_of_others[i];
    each.push_back(std::move(view));
  }
  Json json = CountsToJson(check.total);
  json["views"] = std::move(each);
  return json;
}

Json SupportToJson(const SurfaceSupport& support,
                   const std::vector<View>& views) {
  const BlindPart& blind = support.blind;
  return {{"decided_by_photographs", support.photographs},
          {"decided_by_silhouettes", support.silhouettes},
          {"decided_by_nothing", support.nothing},
          {"agreement", support.agreement},
          {"seen_by_fewer_than_two_views",
           {{"share", blind.share},
            {"hidden_by_the_object", blind.hidden},
            {"from_above", blind.above},
            {"from_below", blind.below},
            {"from_aside", blind.aside},
            {"nearest_view",
             blind.nearest_view ? Json(views[*blind.nearest_view].name)
                                : Json()}}}};
}

}  // namespace

Json VerdictToJson(const MeshVerdict& verdict,
                   const VerdictText& words,
                   const std::vector<View>& views) {
  size_t removed = 0;
  for (const size_t pixels : verdict.removed_pixels) {
    removed += pixels;
  }
  Json json;
  json["findings"] = words.findings;
  json["warnings"] = words.warnings;
  json["masks_as_given"] = MasksToJson(verdict.given_masks, views);
  json["masks_as_repaired"] = MasksToJson(verdict.repaired_masks, views);
  json["border_shift"] = verdict.border_shift;
  json["missed_pixels_of_thin_parts"] = verdict.num_thin_pixels;
  json["pixels_of_removed_components"] = removed;
  if (verdict.surface) {
    json["surface"] = SupportToJson(*verdict.surface, views);
  }
  json["silhouette_seconds"] = verdict.silhouette_seconds;
  json["surface_seconds"] = verdict.surface_seconds;
  return json;
}

}  // namespace octacut
