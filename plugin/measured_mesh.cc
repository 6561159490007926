#include "plugin/measured_mesh.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <utility>

#include "core/base/check_option.h"
#include "core/base/error.h"
#include "core/mesh/audit.h"
#include "core/mesh/self_intersections.h"
#include "plugin/mesh_json.h"
#include "plugin/read_mesh.h"

namespace octacut {

namespace fs = std::filesystem;

namespace {

// What COLMAP makes of depth maps.
bool HasDenseName(const fs::path& path) {
  const std::string stem = path.stem().string();
  return stem == "fused" || stem == "meshed-poisson" ||
         stem == "meshed-delaunay" || stem == "meshed-advancing-front";
}

// Empty unless stereo/octacut-depths.json beside the file says that the depth
// maps are octacut's.
std::string MarkOfDepths(const fs::path& path) {
  if (!HasDenseName(path)) {
    return "";
  }
  std::ifstream stream(path.parent_path() / "stereo" / "octacut-depths.json");
  if (!stream) {
    return "";
  }
  const Json note = Json::parse(stream, nullptr, false);
  const bool has_kept_others =
      note.is_object() && note.value("kept_maps", Json(0)) != Json(0);
  return has_kept_others ? " (made in part from octacut's depths)"
                         : " (made from octacut's depths)";
}

}  // namespace

MeasuredMesh MeasureMesh(const fs::path& path,
                         const std::string& name,
                         bool self_intersections,
                         const Context& context,
                         AllowClouds clouds) {
  const Phase phase(context, fmt::format("audit of {}", name));
  MeshFile file = ReadMeshAndLog(path, context);
  if (file.mesh.triangles.empty() &&
      (clouds == AllowClouds::kNo || file.mesh.positions.empty())) {
    throw InputError(fmt::format("{}: the mesh has no faces, only {} vertices",
                                 path.string(),
                                 file.mesh.positions.size()));
  }
  MeasuredMesh measured = MeasureMesh(
      std::move(file.mesh), path, name, self_intersections, context);
  measured.json["notes"] = file.notes;
  return measured;
}

MeasuredMesh MeasureMesh(IndexedMesh mesh,
                         const fs::path& path,
                         const std::string& name,
                         bool self_intersections,
                         const Context& context) {
  MeasuredMesh measured;
  measured.result.name = name;
  measured.result.audit = AuditMesh(mesh, context);
  if (!mesh.triangles.empty() && !(measured.result.audit.area > 0)) {
    throw InputError(
        fmt::format("{}: its triangles have no area", path.string()));
  }
  measured.json["name"] = name;
  measured.json["path"] = path.string();
  measured.json["notes"] = Json::array();
  measured.json["audit"] = AuditToJson(measured.result.audit);
  if (self_intersections && !mesh.triangles.empty()) {
    measured.result.self_intersections = FindSelfIntersections(mesh, context);
    measured.json["self_intersections"] =
        SelfIntersectionsToJson(*measured.result.self_intersections);
  }
  measured.mesh = std::move(mesh);
  return measured;
}

std::string NameAmong(const fs::path& path,
                      const std::vector<fs::path>& paths) {
  size_t num_equal = 0;
  for (const fs::path& other : paths) {
    num_equal += other.filename() == path.filename();
  }
  return (num_equal > 1 ? path.string() : path.filename().string()) +
         MarkOfDepths(path);
}

std::vector<fs::path> SplitPaths(const std::string& option,
                                 const std::vector<fs::path>& values) {
  std::vector<fs::path> paths;
  for (const fs::path& value : values) {
    std::error_code ignored;
    if (fs::exists(value, ignored)) {
      paths.push_back(value);
      continue;
    }
    // The comma at the end lets a name end the list, even an empty one.
    std::istringstream list(value.string() + ',');
    for (std::string part; std::getline(list, part, ',');) {
      CheckOption(!part.empty(),
                  option,
                  value.string(),
                  "must be names of files separated by commas, none of them "
                  "empty");
      paths.emplace_back(part);
    }
  }
  return paths;
}

}  // namespace octacut
