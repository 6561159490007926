// The surface around a vertex as a quadric over its tangent plane: smooth
// where the mesh still has the steps of its voxels, yet curved, so that a patch
// of samples on it looks alike from all sides (a plane would not where the
// object is round).
#pragma once

#include <algorithm>
#include <cmath>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/vertex_corners.h"

namespace octacut {

// Points center + x * tangent_u + y * tangent_v + Height(x, y) * normal.
struct LocalSurface {
  Eigen::Vector3f center;  // the point of the quadric next to the vertex
  Eigen::Vector3f normal;  // there; of unit length, outward
  Eigen::Vector3f tangent_u;
  float uu = 0;
  float uv = 0;
  float vv = 0;
  // The height of the center above the vertex, along the normal.
  float height = 0;

  Eigen::Vector3f TangentV() const { return normal.cross(tangent_u); }
  float Height(float x, float y) const {
    return uu * x * x + uv * x * y + vv * y * y;
  }
  // Largest one at the center, either way, 1 / unit.
  float Curvature() const {
    return std::abs(uu + vv) + std::hypot(uu - vv, uv);
  }
  // Largest convex normal curvature at the center, 0 if there is none, 1 /
  // unit.
  float ConvexCurvature() const {
    return std::max(0.0f, std::hypot(uu - vv, uv) - (uu + vv));
  }
  // Outward, not of unit length.
  Eigen::Vector3f NormalAt(float x, float y) const {
    return normal - (2 * uu * x + uv * y) * tangent_u -
           (uv * x + 2 * vv * y) * TangentV();
  }
};

// One for each of `vertices` of `mesh`, which has normals, by weighted least
// squares over the vertices that are within `radius` and connected with it
// there; where the mesh is much finer than the radius, over points that stand
// for several vertices, so that neither the surface nor the time depends on how
// fine it is. `neighbors` are those of FindVertexNeighbors. A vertex with too
// few neighbours gets its tangent plane.
std::vector<LocalSurface> FitLocalSurfaces(
    const IndexedMesh& mesh,
    const VertexCorners& neighbors,
    const std::vector<uint32_t>& vertices,
    double radius,
    const Context& context);

}  // namespace octacut
