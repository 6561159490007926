#include "core/extract/position_vertices.h"

#include <fmt/format.h>

#include <array>
#include <Eigen/Core>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/extract/octant_mean.h"
#include "core/mesh/untangle.h"

namespace octacut {

IndexedMesh PositionVertices(ExtractedSurface surface, const Context& context) {
  constexpr size_t kGrain = 1 << 16;
  std::array<Eigen::Vector3d, 256> offsets;
  for (int octants = 0; octants < 256; ++octants) {
    offsets[octants] = surface.voxel_size * OctantMean(OctantMask(octants));
  }
  IndexedMesh mesh = std::move(surface.mesh);
  std::vector<Eigen::Vector3d>& positions = mesh.positions;
  const std::vector<Eigen::Vector3d> corners = positions;
  ParallelEach(context, positions.size(), kGrain, [&](size_t v) {
    positions[v] += offsets[surface.octants[v]];
  });
  const size_t num_thin =
      Untangle(corners, kMinTriangleHeight * surface.voxel_size, context, &mesh)
          .num_thin;
  if (num_thin > 0) {
    throw InvariantError(
        fmt::format("{} triangles are degenerate at voxel corners", num_thin));
  }
  return mesh;
}

}  // namespace octacut
