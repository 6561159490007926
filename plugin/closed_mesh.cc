#include "plugin/closed_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/audit.h"
#include "core/mesh/mean_edge.h"
#include "core/mesh/untangle.h"
#include "plugin/read_mesh.h"

namespace octacut {

namespace fs = std::filesystem;

namespace {

// Rounding may move vertices by a twentieth of a side, as far as a surface is
// rounded in reconstruction.
void RequireFloatsSuffice(const IndexedMesh& mesh,
                          const std::vector<Eigen::Vector3d>& rounded,
                          const fs::path& path) {
  constexpr double kMaxShareOfSide = 0.05;
  double most = 0;
  for (size_t v = 0; v < rounded.size(); ++v) {
    most = std::max(most, (rounded[v] - mesh.positions[v]).norm());
  }
  const double side = MeanEdge(mesh);
  if (most > kMaxShareOfSide * side) {
    throw InputError(
        fmt::format("{}: in single precision, which octacut keeps meshes in, "
                    "vertices move by up to {:.3g}, and the sides of triangles "
                    "have a mean length of {:.3g}. Move the mesh to the origin "
                    "first",
                    path.string(),
                    most,
                    side));
  }
}

}  // namespace

IndexedMesh ReadClosedMesh(const fs::path& path, const Context& context) {
  IndexedMesh mesh = ReadMeshAndLog(path, context).mesh;
  // What is audited is what steps keep and files hold.
  std::vector<Eigen::Vector3d> rounded = mesh.positions;
  RoundToFloats(&rounded);
  RequireFloatsSuffice(mesh, rounded, path);
  mesh.positions = std::move(rounded);
  const std::string failure = AuditMesh(mesh, context).DescribeFailure();
  if (!failure.empty()) {
    throw InputError(fmt::format("{}: {}", path.string(), failure));
  }
  return mesh;
}

}  // namespace octacut
