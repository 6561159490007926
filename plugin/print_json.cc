#include "plugin/print_json.h"

#include "plugin/vector_json.h"

namespace octacut {

Json WallThicknessToJson(const WallThickness& walls) {
  Json json;
  json["measured_share"] = walls.measured_share;
  json["min"] = walls.min;
  json["percentile_1"] = walls.percentile_1;
  json["percentile_5"] = walls.percentile_5;
  json["median"] = walls.median;
  json["max"] = walls.max;
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
