#include "colmap_io/mesh/mesh_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <utility>

#include "colmap_io/files/lower_extension.h"
#include "colmap_io/mesh/glb_writer.h"
#include "colmap_io/mesh/mesh_readers.h"
#include "colmap_io/mesh/mesh_writers.h"
#include "core/base/error.h"

namespace octacut {
namespace {

bool BeginsAsPly(ByteSource* source) {
  const std::string_view head = source->Peek(4);
  return head == "ply\n" || head == "ply\r";
}

void CheckSizes(const IndexedMesh& mesh) {
  const size_t count = mesh.positions.size();
  const auto fits = [&](const auto& values) {
    return values.empty() || values.size() == count;
  };
  if (!fits(mesh.normals) || !fits(mesh.colors) || !fits(mesh.confidence)) {
    throw InvariantError(
        fmt::format("mesh to write has {} vertices, {} normals, {} colours, "
                    "{} confidences",
                    count,
                    mesh.normals.size(),
                    mesh.colors.size(),
                    mesh.confidence.size()));
  }
}

// What is computed from coordinates, and their boxes in floats, is to be
// finite.
constexpr double kMaxCoordinate = 1e30;

void CheckCoordinates(const IndexedMesh& mesh, const std::string& name) {
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    const double largest = mesh.positions[v].cwiseAbs().maxCoeff();
    if (largest > kMaxCoordinate) {
      throw InputError(fmt::format(
          "{}: vertex {}: a coordinate of {:g} exceeds the limit of {:g}",
          name,
          v,
          largest,
          kMaxCoordinate));
    }
  }
}

MeshFile ReadFrom(ByteSource* source,
                  MeshFormat format,
                  const std::string& name) {
  MeshFile result;
  PolygonMesh polygons;
  switch (format) {
    case MeshFormat::kPly:
      polygons = ReadPly(source, &result.notes);
      RemoveNonFinite(name, &polygons, &result.notes);
      break;
    case MeshFormat::kObj:
      polygons = ReadObj(source, &result.notes);
      break;
    case MeshFormat::kOff:
      polygons = ReadOff(source, &result.notes);
      break;
    case MeshFormat::kStl:
      polygons = ReadStl(source, &result.notes);
      break;
    case MeshFormat::k3mf:
      source->Fail("3MF can be written, but not read; use .stl or .ply");
    case MeshFormat::kGlb:
      throw InputError(
          fmt::format("{}: .glb files are written, but not read", name));
  }
  result.mesh = Triangulate(std::move(polygons), name, &result.notes);
  CheckCoordinates(result.mesh, name);
  return result;
}

}  // namespace

MeshFormat MeshFormatOf(const std::filesystem::path& path) {
  const std::string extension = LowerExtension(path);
  if (extension == ".ply") return MeshFormat::kPly;
  if (extension == ".obj") return MeshFormat::kObj;
  if (extension == ".off") return MeshFormat::kOff;
  if (extension == ".stl") return MeshFormat::kStl;
  if (extension == ".3mf") return MeshFormat::k3mf;
  if (extension == ".glb") return MeshFormat::kGlb;
  throw OptionError(fmt::format(
      "{}: unknown mesh extension \"{}\": must be .ply, .obj, .off or .stl (or "
      ".3mf or .glb, which are only written)",
      path.string(),
      extension));
}

MeshFile ReadMesh(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw InputError(fmt::format("{}: is a folder, not a mesh", path.string()));
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw InputError(fmt::format("{}: cannot be opened", path.string()));
  }
  ByteSource source(stream, path.string());
  const MeshFormat format =
      BeginsAsPly(&source) ? MeshFormat::kPly : MeshFormatOf(path);
  return ReadFrom(&source, format, path.string());
}

MeshFile ReadMesh(std::istream& stream,
                  MeshFormat format,
                  const std::string& name) {
  ByteSource source(stream, name);
  return ReadFrom(&source, format, name);
}

void WriteMesh(const std::filesystem::path& path, const IndexedMesh& mesh) {
  AtomicFiles files;
  WriteMesh(path, mesh, &files);
  files.Commit();
}

void WriteMesh(const std::filesystem::path& path,
               const IndexedMesh& mesh,
               AtomicFiles* files) {
  const MeshFormat format = MeshFormatOf(path);
  CheckSizes(mesh);
  files->Write(path,
               [&](std::ostream& stream) { WriteMesh(stream, format, mesh); });
}

void WriteMeshWithValues(const std::filesystem::path& path,
                         IndexedMesh mesh,
                         std::vector<float> values,
                         std::string_view name,
                         AtomicFiles* files) {
  mesh.confidence = std::move(values);
  CheckSizes(mesh);
  files->Write(path,
               [&](std::ostream& stream) { WritePly(mesh, stream, name); });
}

void WriteMesh(std::ostream& stream,
               MeshFormat format,
               const IndexedMesh& mesh) {
  CheckSizes(mesh);
  switch (format) {
    case MeshFormat::kPly:
      return WritePly(mesh, stream);
    case MeshFormat::kObj:
      return WriteObj(mesh, stream);
    case MeshFormat::kOff:
      return WriteOff(mesh, stream);
    case MeshFormat::kStl:
      return WriteStl(mesh, stream);
    case MeshFormat::k3mf:
      return Write3mf(mesh, stream);
    case MeshFormat::kGlb:
      return WriteGlb(mesh, stream);
  }
}

void CheckMeshPath(const std::filesystem::path& path) {
  MeshFormatOf(path);
  CheckFilePath(path);
}

}  // namespace octacut
