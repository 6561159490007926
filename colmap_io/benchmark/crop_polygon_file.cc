#include "colmap_io/benchmark/crop_polygon_file.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "colmap_io/files/read_file.h"
#include "core/base/error.h"

namespace octacut {
namespace {

using nlohmann::json;

[[noreturn]] void Fail(const std::filesystem::path& path,
                       const std::string& field,
                       const std::string& problem) {
  throw InputError(fmt::format("{}: {}: {}", path.string(), field, problem));
}

double ReadNumber(const std::filesystem::path& path,
                  const std::string& field,
                  const json& value) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) {
    Fail(path, field, fmt::format("must be a number, is {}", value.dump()));
  }
  return value.get<double>();
}

const json& Member(const std::filesystem::path& path,
                   const json& object,
                   const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) {
    Fail(path, name, "is missing");
  }
  return *found;
}

json ReadJson(const std::filesystem::path& path) {
  json document = json::parse(ReadFile(path), nullptr, false);
  if (!document.is_object()) {
    throw InputError(
        fmt::format("{}: is not a JSON file with a crop volume of Tanks and "
                    "Temples (Open3D's SelectionPolygonVolume)",
                    path.string()));
  }
  return document;
}

}  // namespace

CropPolygon ReadCropPolygon(const std::filesystem::path& path) {
  const json document = ReadJson(path);
  CropPolygon crop;
  const json& axis = Member(path, document, "orthogonal_axis");
  const std::string name = axis.is_string() ? axis.get<std::string>() : "";
  const size_t index = std::string("XYZxyz").find(name);
  if (name.size() != 1 || index == std::string::npos) {
    Fail(path,
         "orthogonal_axis",
         fmt::format("must be X, Y or Z, is {}", axis.dump()));
  }
  crop.axis = static_cast<int>(index % 3);
  for (const auto& [field, value] : {std::pair("axis_min", &crop.axis_min),
                                     std::pair("axis_max", &crop.axis_max)}) {
    *value = ReadNumber(path, field, Member(path, document, field));
  }
  if (!(crop.axis_min < crop.axis_max)) {
    Fail(path, "axis_max", "must be greater than axis_min");
  }
  const json& polygon = Member(path, document, "bounding_polygon");
  if (!polygon.is_array() || polygon.size() < 3) {
    Fail(path, "bounding_polygon", "must be a list of at least three points");
  }
  for (const json& point : polygon) {
    if (!point.is_array() || point.size() != 3) {
      Fail(path,
           "bounding_polygon",
           fmt::format("must hold points, has {}", point.dump()));
    }
    Eigen::Vector3d& corner = crop.polygon.emplace_back();
    for (size_t i = 0; i < 3; ++i) {
      corner[static_cast<Eigen::Index>(i)] =
          ReadNumber(path, "bounding_polygon", point[i]);
    }
  }
  return crop;
}

}  // namespace octacut
