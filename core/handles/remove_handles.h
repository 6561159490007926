// Removes the smallest handles of a closed mesh.
//
// Where neither the images nor the hull decide, a cut leaves bridges and
// pinholes of a voxel or two. After Guskov & Wood, Topological noise removal
// (Graphics Interface 2001), each is cut along the shortest loop around it and
// both sides are closed: that takes a bridge away and fills a tunnel.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <functional>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

// Lengths are world units.
struct RemoveHandlesOptions {
  // Loops up to this length are cut, twice it around a tunnel; 0: none are.
  double max_length = 0;
  // New triangles are no thinner (thin_triangles.h).
  double min_height = 0;
  // Loops of both kinds are also cut if they are at most `max_length_anywhere`
  // long and no longer than `max_length_at` at any of their vertices. Without
  // `max_length_at`, `max_length_anywhere` must be 0.
  std::function<double(const Eigen::Vector3d&)> max_length_at = nullptr;
  double max_length_anywhere = 0;
};

struct RemoveHandlesSummary {
  size_t num_removed = 0;
  // Loops that were not cut: what closes them would be thin or run through
  // other triangles.
  size_t num_refused = 0;
};

struct RemovedHandles {
  IndexedMesh mesh;  // without normals and colours where handles were removed
  RemoveHandlesSummary summary;
};

// Removes handles around which there is a loop of edges that does not cut the
// surface in two and is short enough, the shortest first: the genus falls by
// one with each, no component falls apart. A handle all of whose loops are
// refused stays. `mesh` is to be closed, oriented and free of
// self-intersections, and stays so; its vertices and triangles keep their
// numbers.
RemovedHandles RemoveHandles(IndexedMesh mesh,
                             const RemoveHandlesOptions& options,
                             const Context& context);

}  // namespace octacut
