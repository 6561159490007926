#include "core/extract/position_vertices.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "core/base/check_option.h"
#include "core/base/parallel.h"
#include "core/extract/octant_mean.h"
#include "core/mesh/untangle.h"

namespace octacut {

void PositionVerticesOptions::Check() const {
  CheckOption(min_height > 0 && min_height <= 0.4,
              "min_height",
              min_height,
              "must be in (0, 0.4]");
}

PositionedSurface PositionVertices(ExtractedSurface surface,
                                   const PositionVerticesOptions& options,
                                   const Context& context) {
  options.Check();
  constexpr size_t kGrain = 1 << 16;
  std::array<Eigen::Vector3d, 256> offsets;
  for (int octants = 0; octants < 256; ++octants) {
    offsets[octants] = surface.voxel_size * OctantMean(OctantMask(octants));
  }
  PositionedSurface result;
  result.mesh = std::move(surface.mesh);
  std::vector<Eigen::Vector3d>& positions = result.mesh.positions;
  result.corners = positions;
  ParallelEach(context, positions.size(), kGrain, [&](size_t v) {
    positions[v] += offsets[surface.octants[v]];
  });
  const size_t num_thin = Untangle(result.corners,
                                   options.min_height * surface.voxel_size,
                                   context,
                                   &result.mesh)
                              .num_thin;
  if (num_thin > 0) {
    throw InvariantError(
        fmt::format("{} triangles are degenerate at voxel corners", num_thin));
  }
  return result;
}

}  // namespace octacut
