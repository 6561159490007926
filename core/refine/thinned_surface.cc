#include "core/refine/thinned_surface.h"

#include "core/mesh/mean_edge.h"

namespace octacut {
namespace {

// Below this many edges of the mesh there would be hardly fewer samples than
// vertices.
constexpr double kMinSpacing = 1.5;

}  // namespace

ThinnedSurface::ThinnedSurface(const IndexedMesh& mesh,
                               const VertexCorners& neighbors,
                               double spacing)
    : mesh_(mesh), neighbors_(neighbors) {
  if (spacing <= kMinSpacing * MeanEdge(mesh)) {
    return;
  }
  points_ = SpreadPoints(mesh, neighbors, spacing);
  const size_t count = points_.vertices.size();
  positions_.assign(count, Eigen::Vector3d::Zero());
  normals_.assign(count, Eigen::Vector3f::Zero());
  std::vector<uint32_t> sizes(count, 0);
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    const uint32_t point = points_.point_of[v];
    positions_[point] += mesh.positions[v];
    normals_[point] += mesh.normals[v];
    ++sizes[point];
  }
  for (size_t i = 0; i < count; ++i) {
    positions_[i] /= double(sizes[i]);
    normals_[i].normalize();
  }
}

}  // namespace octacut
