#include "core/simplify/collapse_rules.h"

#include <algorithm>
#include <array>
#include <Eigen/Geometry>

namespace octacut {
namespace {

// cos 60 degrees: the normals of two neighbours that both turn by less do not
// come to face each other.
constexpr double kMinCosine = 0.5;
// Least height over the longest edge. It is far above what rounding to floats
// does to a triangle, and printers and renderers have no use for thinner ones.
constexpr double kMinShape = 0.01;

using Triangle = std::array<Eigen::Vector3d, 3>;

// Twice the area long.
Eigen::Vector3d NormalOf(const Triangle& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]);
}

double SquaredLongest(const Triangle& t) {
  return std::max({(t[1] - t[0]).squaredNorm(),
                   (t[2] - t[1]).squaredNorm(),
                   (t[0] - t[2]).squaredNorm()});
}

bool IsAcceptable(const Triangle& before, const Triangle& after) {
  const Eigen::Vector3d normal_before = NormalOf(before);
  const Eigen::Vector3d normal_after = NormalOf(after);
  const double squared_before = normal_before.squaredNorm();
  const double squared_after = normal_after.squaredNorm();
  const double dot = normal_before.dot(normal_after);
  if (!(dot > 0) ||
      dot * dot <= kMinCosine * kMinCosine * squared_before * squared_after) {
    return false;
  }
  // The height over the longest edge is the normal's length over the square of
  // that edge.
  const double longest_after = SquaredLongest(after);
  if (squared_after >= kMinShape * kMinShape * longest_after * longest_after) {
    return true;
  }
  const double longest_before = SquaredLongest(before);
  return squared_after * longest_before * longest_before >=
         squared_before * longest_after * longest_after;
}

}  // namespace

bool KeepsTriangleShapes(const SurfaceMesh& mesh,
                         SurfaceMesh::HalfedgeHandle edge) {
  const auto from = mesh.from_vertex_handle(edge);
  const auto to = mesh.to_vertex_handle(edge);
  const Eigen::Vector3d& old_place = mesh.point(from);
  const Eigen::Vector3d& new_place = mesh.point(to);
  for (auto spoke = mesh.cvoh_iter(from); spoke.is_valid(); ++spoke) {
    const auto first = mesh.to_vertex_handle(*spoke);
    const auto second =
        mesh.to_vertex_handle(mesh.next_halfedge_handle(*spoke));
    if (first == to || second == to) {
      continue;  // goes with the edge
    }
    const Eigen::Vector3d& b = mesh.point(first);
    const Eigen::Vector3d& c = mesh.point(second);
    if (!IsAcceptable({old_place, b, c}, {new_place, b, c})) {
      return false;
    }
  }
  return true;
}

bool KeepsManifold(SurfaceMesh& mesh, SurfaceMesh::HalfedgeHandle edge) {
  if (!mesh.is_collapse_ok(edge)) {
    return false;
  }
  // Where both opposite vertices have three neighbours and are joined, two
  // triangles would become one and its back.
  const auto left = mesh.to_vertex_handle(mesh.next_halfedge_handle(edge));
  const auto right = mesh.to_vertex_handle(
      mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(edge)));
  return !(mesh.find_halfedge(left, right).is_valid() &&
           mesh.valence(left) == 3 && mesh.valence(right) == 3);
}

}  // namespace octacut
