// One step of aligning two surfaces from pairs of points.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/similarity.h"

namespace octacut {

// A point of the moved mesh and the point of the reference it should be at.
struct AlignPair {
  Eigen::Vector3d moved;
  Eigen::Vector3d target;
  Eigen::Vector3d normal;  // of the reference, at `target`
  double distance;         // infinite: does not count
  double weight;           // of its squared distance along the normal
  uint32_t closest;        // triangle of the surface that was searched
};

struct AlignStep {
  Similarity3d better_from_moved;
  // How far the motion moves a point at `size` from the centre, over `size`.
  double largest_motion = 0;
};

// The similarity that minimises the weighted sum of (normal . (target -
// motion(moved)))^2 over the pairs, with the motion linearised about
// `center`, in units of `size` (Chen & Medioni 1992). Motions that the pairs do
// not determine stay zero; large turns are shortened.
AlignStep SolveAlignStep(const std::vector<AlignPair>& pairs,
                         const Eigen::Vector3d& center,
                         double size,
                         bool estimate_scale,
                         const Context& context);

}  // namespace octacut
