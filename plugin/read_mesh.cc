#include "plugin/read_mesh.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "colmap_io/mesh/mesh_io.h"

namespace octacut {

IndexedMesh ReadMeshAndLog(const std::filesystem::path& path,
                           const Context& context) {
  MeshFile file = ReadMesh(path);
  for (const std::string& note : file.notes) {
    context.Info(fmt::format("{}: {}", path.string(), note));
  }
  return std::move(file.mesh);
}

}  // namespace octacut
