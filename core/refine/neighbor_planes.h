// How a quantity goes on from the neighbours of a point to the point itself:
// by the plane through its values, so that what tilts evenly has no bending
// energy, however uneven the points are spread. Across an edge it does not go
// on: one face may move without the other.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/mesh/vertex_corners.h"
#include "core/refine/local_surface.h"

namespace octacut {

struct NeighborPlanes {
  // The share of each neighbour's value, in the order of neighbors.entries, in
  // the plane's value at the point (they sum to 1) and in its slope there.
  std::vector<float> shares;
  std::vector<Eigen::Vector3f> slopes;
  // For each point, the root mean square of the distances to its neighbours.
  std::vector<float> spacings;

  // The slopes of the planes through `values`, one per point.
  std::vector<Eigen::Vector3f> Slopes(const std::vector<double>& values,
                                      const VertexCorners& neighbors) const;
};

// Planes by least squares over the tangent planes of `surfaces`, one per point,
// in which neighbours weigh the less the more their normals differ;
// `neighbors` are those of SurfacePoints.
NeighborPlanes FitNeighborPlanes(const std::vector<LocalSurface>& surfaces,
                                 const VertexCorners& neighbors);

}  // namespace octacut
