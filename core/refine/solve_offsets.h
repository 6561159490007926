// From what views and silhouettes measure here and there to one smooth,
// robust offset a vertex: a sparse non-linear least-squares problem (Ceres).
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/vertex_corners.h"

namespace octacut {

// weight * (fraction of the way from one vertex's offset to the other's -
// target) shall vanish.
struct EdgeTarget {
  std::array<uint32_t, 2> vertices;
  float fraction;  // 0: of the first vertex, 1: of the second
  float target;
  float weight;
};

struct OffsetProblem {
  // Vertex v goes to positions[v] + offset * normals[v]. The unit of all
  // lengths is that of the offsets.
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> normals;
  // 0: the vertex stays.
  std::vector<uint8_t> is_free;
  // weights[v] * (offset - targets[v]) shall vanish, robustly; weight 0: none.
  std::vector<float> targets;
  std::vector<float> weights;
  std::vector<EdgeTarget> edge_targets;
  // The bend of the surface at v: how far the mean of its neighbours is above
  // it, along its normal.
  std::vector<float> bends;
};

struct SolveOffsetsOptions {
  // Of the difference between a bend and what it should be.
  double smoothness = 4;
  // Of an offset that nothing is known of.
  double anchor = 0.02;
  // Residuals beyond this weigh like outliers (Cauchy's loss).
  double outlier_scale = 1;
};

// The offsets, zero for vertices that stay; the same bytes for any number of
// threads.
std::vector<double> SolveOffsets(const OffsetProblem& problem,
                                 const VertexCorners& neighbors,
                                 const SolveOffsetsOptions& options,
                                 const Context& context);

}  // namespace octacut
