// Takes back what moved vertices must not do: leave the hull, squeeze
// triangles to nothing, run through each other.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/vertex_corners.h"
#include "core/views/view_set.h"

namespace octacut {

// Unit coordinates.
struct ValidMoves {
  const std::vector<Eigen::Vector3d>& start;   // before the first of the moves
  const std::vector<Eigen::Vector3d>& before;  // before the last one
  double tolerance;                            // to masks, pixels
  double pixel;                                // size of one at the surface
};

// Moves vertices of `mesh` back towards `before`, in steps up to the whole way,
// - that are more than `tolerance` pixels out of a mask and farther than they
//   were at `start` and `before`, where an earlier move with a larger tolerance
//   may have left them;
// - of triangles that are thinner than a hundredth of `pixel`; those of
//   triangles that were at `before` stay there;
// - of triangles that intersect others, until none do but those that did at
//   `before`.
// What is left standing out by the last two is smoothed, as far as it stays
// valid. `neighbors` are those of FindVertexNeighbors, coordinates unit
// coordinates. Returns how many vertices were moved back.
size_t KeepValid(const ViewSet& views,
                 const VertexCorners& neighbors,
                 const ValidMoves& moves,
                 const Context& context,
                 IndexedMesh* mesh);

// The last two parts of that alone, without smoothing, in any coordinates,
// which are floats and stay so; `pixel` is in those.
size_t KeepFloatsValid(const std::vector<Eigen::Vector3d>& before,
                       double pixel,
                       const Context& context,
                       IndexedMesh* mesh);

}  // namespace octacut
