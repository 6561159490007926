#include "plugin/read_mesh.h"

#include <fmt/format.h>

#include <string>

namespace octacut {

MeshFile ReadMeshAndLog(const std::filesystem::path& path,
                        const Context& context) {
  MeshFile file = ReadMesh(path);
  for (const std::string& note : file.notes) {
    context.Info(fmt::format("{}: {}", path.string(), note));
  }
  return file;
}

}  // namespace octacut
