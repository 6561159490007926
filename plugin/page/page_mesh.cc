#include "plugin/page/page_mesh.h"

#include <cmath>
#include <Eigen/Geometry>

#include "core/mesh/bounding_box.h"
#include "plugin/vector_json.h"

namespace octacut {
namespace {

constexpr double kSteps = 65535;

std::vector<uint16_t> Quantise(const std::vector<Eigen::Vector3d>& positions,
                               const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d sizes = box.sizes();
  std::vector<uint16_t> quantised;
  quantised.reserve(3 * positions.size());
  for (const Eigen::Vector3d& position : positions) {
    for (int axis = 0; axis < 3; ++axis) {
      const double part = sizes[axis] > 0
                              ? (position[axis] - box.min()[axis]) / sizes[axis]
                              : 0;
      quantised.push_back(static_cast<uint16_t>(std::lround(kSteps * part)));
    }
  }
  return quantised;
}

std::vector<uint8_t> IndexBytes(
    const std::vector<std::array<uint32_t, 3>>& triangles) {
  std::vector<uint8_t> bytes;
  bytes.reserve(9 * triangles.size());
  for (const auto& triangle : triangles) {
    for (const uint32_t corner : triangle) {
      for (const int shift : {0, 8, 16}) {
        bytes.push_back(static_cast<uint8_t>(corner >> shift));
      }
    }
  }
  return bytes;
}

}  // namespace

Json PlacesToJson(const std::vector<RemarkablePlace>& places,
                  const std::string& value_key) {
  Json array = Json::array();
  for (const RemarkablePlace& place : places) {
    array.push_back({{value_key, place.value},
                     {"position", VectorToJson(place.position)},
                     {"normal", VectorToJson(place.normal)}});
  }
  return array;
}

Json PageMeshToJson(const PageMesh& mesh, PageBlobs* blobs) {
  const IndexedMesh& display = mesh.display.mesh;
  const Eigen::AlignedBox3d box = BoundingBox(display);
  Json json;
  json["name"] = mesh.name;
  json["reference"] = mesh.is_reference;
  json["full_triangles"] = mesh.num_triangles;
  json["full_points"] = mesh.num_points;
  json["vertices"] = display.positions.size();
  json["triangles"] = display.triangles.size();
  json["simplified"] = mesh.display.is_simplified;
  json["box_min"] = VectorToJson(box.min());
  json["box_max"] = VectorToJson(box.max());
  json["positions"] = blobs->AddValues(Quantise(display.positions, box));
  json["indices"] = blobs->Add(IndexBytes(display.triangles));
  if (!mesh.colors.empty()) {
    json["colors"] = blobs->AddValues(mesh.colors);
  }
  json["values"] = Json::array();
  for (const PageValues& values : mesh.values) {
    std::vector<float> shown;
    shown.reserve(mesh.display.sources.size());
    for (const uint32_t source : mesh.display.sources) {
      shown.push_back(values.values[source]);
    }
    json["values"].push_back({{"kind", values.kind},
                              {"label", values.label},
                              {"blob", blobs->AddValues(shown)}});
  }
  json["place_kind"] = mesh.place_kind;
  json["places"] = PlacesToJson(mesh.places, "value");
  return json;
}

}  // namespace octacut
