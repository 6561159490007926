#include "plugin/closed_mesh.h"

#include <fmt/format.h>

#include "colmap_io/mesh/mesh_io.h"
#include "core/base/error.h"
#include "core/mesh/audit.h"
#include "core/mesh/untangle.h"

namespace octacut {

namespace fs = std::filesystem;

IndexedMesh ReadClosedMesh(const fs::path& path, const Context& context) {
  IndexedMesh mesh = ReadMesh(path).mesh;
  // What is audited is what steps keep and files hold.
  RoundToFloats(&mesh.positions);
  const std::string failure = AuditMesh(mesh, context).DescribeFailure();
  if (!failure.empty()) {
    throw InputError(fmt::format("{}: {}", path.string(), failure));
  }
  return mesh;
}

}  // namespace octacut
