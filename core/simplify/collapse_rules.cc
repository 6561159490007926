#include "core/simplify/collapse_rules.h"

#include <algorithm>
#include <Eigen/Geometry>

namespace octacut {
namespace {

// cos 60 degrees: the normals of two neighbours that both turn by less do not
// come to face each other.
constexpr double kMinCosine = 0.5;
// Least height over the longest edge. It is far above what rounding to floats
// does to a triangle, and printers and renderers have no use for thinner ones.
constexpr double kMinShape = 0.01;

struct Shape {
  Eigen::Vector3d normal;  // twice the area long
  double longest;          // squared length of the longest edge

  Shape(const Eigen::Vector3d& a,
        const Eigen::Vector3d& b,
        const Eigen::Vector3d& c)
      : normal((b - a).cross(c - a)),
        longest(std::max({(b - a).squaredNorm(),
                          (c - b).squaredNorm(),
                          (a - c).squaredNorm()})) {}
  double Height() const { return normal.norm() / longest; }
};

bool IsAcceptable(const Shape& before, const Shape& after) {
  if (!(before.normal.dot(after.normal) >
        kMinCosine * before.normal.norm() * after.normal.norm())) {
    return false;
  }
  const double height = after.Height();
  return height >= kMinShape || height >= before.Height();
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
    if (!IsAcceptable(Shape(old_place, b, c), Shape(new_place, b, c))) {
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
