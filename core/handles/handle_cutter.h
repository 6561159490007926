// Cuts a closed mesh along loops and closes both sides. For core/handles alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <set>
#include <utility>
#include <vector>

#include "core/base/context.h"
#include "core/handles/half_edges.h"
#include "core/handles/handle_loops.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

class HandleCutter {
 public:
  // Keeps references to both.
  HandleCutter(const IndexedMesh& mesh, const HalfEdges& half_edges);

  // Gives the triangles to the right of the loop vertices of their own, parts
  // both sides a little and closes each by a fan around its middle. No triangle
  // may touch two of the loops.
  void Cut(const HandleLoop& loop);

  // Loops, by the order of their cuts, whose triangles are thinner than
  // `min_height` or intersect others; of two that intersect each other the one
  // that was cut later.
  std::set<size_t> FindFailed(double min_height, const Context& context) const;

  IndexedMesh TakeMesh() { return std::move(cut_); }

 private:
  Eigen::Vector3d Parted(uint32_t vertex, uint32_t from, uint32_t to) const;
  void Close(const std::vector<uint32_t>& border);
  // The loop that a triangle touches; num_loops_ if none.
  size_t LoopOf(size_t triangle) const;

  const IndexedMesh& before_;
  const HalfEdges& half_edges_;
  IndexedMesh cut_;
  std::vector<uint32_t> loop_of_vertex_;  // kNoLoop: of none
  size_t num_loops_ = 0;
};

}  // namespace octacut
