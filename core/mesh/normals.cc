#include "core/mesh/normals.h"

#include <cmath>
#include <Eigen/Geometry>

#include "core/base/parallel.h"
#include "core/mesh/vertex_corners.h"

namespace octacut {
namespace {

// Normal of a triangle times its angle at corner `i`; zero without area.
Eigen::Vector3d WeightedNormal(const IndexedMesh& mesh,
                               const std::array<uint32_t, 3>& triangle,
                               int i) {
  const Eigen::Vector3d& apex = mesh.positions[triangle[i]];
  const Eigen::Vector3d next = mesh.positions[triangle[(i + 1) % 3]] - apex;
  const Eigen::Vector3d previous = mesh.positions[triangle[(i + 2) % 3]] - apex;
  const Eigen::Vector3d cross = next.cross(previous);
  const double length = cross.norm();
  if (!(length > 0)) {
    return Eigen::Vector3d::Zero();
  }
  return std::atan2(length, next.dot(previous)) / length * cross;
}

}  // namespace

std::vector<Eigen::Vector3f> ComputeVertexNormals(const IndexedMesh& mesh,
                                                  const Context& context) {
  constexpr size_t kGrain = 1 << 14;
  const VertexCorners corners =
      FindVertexCorners(mesh.positions.size(), mesh.triangles);
  std::vector<Eigen::Vector3f> normals(mesh.positions.size());
  ParallelEach(context, normals.size(), kGrain, [&](size_t v) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const uint32_t corner : corners.Of(v)) {
      sum += WeightedNormal(mesh, mesh.triangles[corner / 3], corner % 3);
    }
    const double length = sum.norm();
    normals[v] = length > 0 ? Eigen::Vector3f((sum / length).cast<float>())
                            : Eigen::Vector3f::UnitZ();
  });
  return normals;
}

}  // namespace octacut
