// Points that stand for a surface, about as dense as is asked for: the vertices
// of its mesh or, where that is much finer, means over the vertices around
// points on it. What is computed from them depends little on how fine the mesh
// is, in time and in value.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/mesh/indexed_mesh.h"
#include "core/mesh/vertex_corners.h"
#include "core/refine/surface_points.h"

namespace octacut {

// `mesh`, which has normals, and `neighbors` must outlive it.
class ThinnedSurface {
 public:
  // `spacing` in the units of the mesh.
  ThinnedSurface(const IndexedMesh& mesh,
                 const VertexCorners& neighbors,
                 double spacing);

  std::span<const Eigen::Vector3d> Positions() const {
    return IsThinned() ? positions_ : mesh_.positions;
  }
  // A mean of normals that cancel is zero.
  std::span<const Eigen::Vector3f> Normals() const {
    return IsThinned() ? normals_ : mesh_.normals;
  }
  // The sample that stands for a vertex of the mesh.
  uint32_t Of(uint32_t vertex) const {
    return IsThinned() ? points_.point_of[vertex] : vertex;
  }
  std::span<const uint32_t> Neighbors(uint32_t sample) const {
    return IsThinned() ? points_.neighbors.Of(sample) : neighbors_.Of(sample);
  }

 private:
  bool IsThinned() const { return !positions_.empty(); }

  const IndexedMesh& mesh_;
  const VertexCorners& neighbors_;
  // Empty unless the mesh is thinned.
  SurfacePoints points_;
  std::vector<Eigen::Vector3d> positions_;
  std::vector<Eigen::Vector3f> normals_;
};

}  // namespace octacut
