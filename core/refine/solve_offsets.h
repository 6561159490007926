// From what views and silhouettes measure here and there to one smooth,
// robust offset a point: a sparse non-linear least-squares problem (Ceres).
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/vertex_corners.h"

namespace octacut {

// Residual: weight * (offset interpolated at `fraction` between the two points
// - target).
struct EdgeTarget {
  std::array<uint32_t, 2> points;
  float fraction;  // 0: of the first point, 1: of the second
  float target;
  float weight;
};

// Offsets of points along their normals.
struct OffsetProblem {
  std::vector<Eigen::Vector3f> normals;
  // 0: the point stays.
  std::vector<uint8_t> is_free;
  // Robust residuals weights[v] * (offset - targets[v]); weight 0: none.
  std::vector<float> targets;
  std::vector<float> weights;
  std::vector<EdgeTarget> edge_targets;
  // As in NeighborPlanes, spacings in the unit of the offsets.
  std::vector<float> shares;
  std::vector<float> spacings;
};

// RefineOptions has the defaults and limits.
struct SolveOffsetsOptions {
  // Weight of the bending energy that the offsets add to the surface: the
  // square of the height of the plane through a point's neighbours above the
  // point, relative to their spacing. Because of that ratio a weight has the
  // same effect for any spacing.
  double smoothness;
  // Residuals beyond this weigh like outliers (Cauchy's loss).
  double outlier_scale;
};

// The offsets, zero for points that stay; the same bytes for any number of
// threads. `neighbors` are those of SurfacePoints.
std::vector<double> SolveOffsets(const OffsetProblem& problem,
                                 const VertexCorners& neighbors,
                                 const SolveOffsetsOptions& options,
                                 const Context& context);

}  // namespace octacut
