#include "plugin/print_json.h"

#include <utility>

#include "plugin/vector_json.h"

namespace octacut {

Json WallThicknessToJson(const WallThickness& walls) {
  Json json;
  json["measured_share"] = walls.measured_share;
  for (const auto& [key, value] :
       {std::pair("min", walls.min),
        std::pair("percentile_1", walls.percentile_1),
        std::pair("percentile_5", walls.percentile_5),
        std::pair("median", walls.median),
        std::pair("max", walls.max)}) {
    json[key] = walls.measured_share > 0 ? Json(value) : Json();
  }
  json["thin_share"] = walls.thin_share;
  json["histogram"] = walls.histogram;
  json["thinnest"] = Json::array();
  for (const ThinPlace& place : walls.thinnest) {
    json["thinnest"].push_back(
        {{"point", VectorToJson(place.point)}, {"thickness", place.thickness}});
  }
  return json;
}

Json OverhangsToJson(const Overhangs& overhangs) {
  return {{"area", overhangs.area},
          {"share", overhangs.share},
          {"base_area", overhangs.base_area}};
}

}  // namespace octacut
