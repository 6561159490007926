#include "plugin/measured_mesh.h"

#include <fmt/format.h>

#include <sstream>
#include <utility>

#include "colmap_io/files/atomic_files.h"
#include "colmap_io/mesh/mesh_io.h"
#include "core/base/error.h"
#include "core/mesh/audit.h"
#include "core/mesh/self_intersections.h"
#include "plugin/mesh_json.h"

namespace octacut {

namespace fs = std::filesystem;

MeasuredMesh MeasureMesh(const fs::path& path,
                         const std::string& name,
                         bool self_intersections,
                         const Context& context,
                         AllowClouds clouds) {
  const Phase phase(context, fmt::format("Examine {}", name));
  MeshFile file = ReadMesh(path);
  for (const std::string& note : file.notes) {
    context.Info(fmt::format("{}: {}", path.string(), note));
  }
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
  return num_equal > 1 ? path.string() : path.filename().string();
}

std::vector<fs::path> SplitPaths(const std::vector<fs::path>& values) {
  std::vector<fs::path> paths;
  for (const fs::path& value : values) {
    std::error_code ignored;
    if (fs::exists(value, ignored)) {
      paths.push_back(value);
      continue;
    }
    std::istringstream list(value.string());
    for (std::string part; std::getline(list, part, ',');) {
      if (!part.empty()) {
        paths.emplace_back(part);
      }
    }
  }
  return paths;
}

void CheckReportPath(const fs::path& output_path,
                     const std::vector<fs::path>& meshes) {
  if (output_path.empty()) {
    return;
  }
  for (const fs::path& mesh : meshes) {
    std::error_code ignored;
    if (fs::equivalent(mesh, output_path, ignored)) {
      throw OptionError(fmt::format(
          "output_path = {}: must not be one of the compared meshes",
          output_path.string()));
    }
  }
  CheckFilePath(output_path);
}

}  // namespace octacut
