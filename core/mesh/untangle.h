// Keeps moved vertices from running triangles into each other.
#pragma once

#include <array>
#include <cstddef>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/thin_triangles.h"

namespace octacut {

// Least height of a triangle over its longest edge, in voxels, wherever a mesh
// of voxels is made. Parts that are thinner than a voxel would collapse or run
// into each other otherwise.
inline constexpr double kMinTriangleHeight = 0.02;

// What is left of a vertex' way each time that it is moved back.
inline constexpr std::array<double, 4> kLeftOfWay = {1, 0.5, 0.25, 0};

// A position as files keep it. What does not intersect in doubles may once it
// is rounded.
inline Eigen::Vector3d RoundedToFloats(const Eigen::Vector3d& position) {
  // Where GCC 12 vectorizes a way to float and back it leaves it out.
  const auto round = [](double coordinate) {
    const volatile float rounded = float(coordinate);
    return double(rounded);
  };
  return {round(position.x()), round(position.y()), round(position.z())};
}
void RoundToFloats(std::vector<Eigen::Vector3d>* positions);

// Moves vertices of `mesh` back towards `start` (as kLeftOfWay has it) that
// belong to triangles which intersect others, until none do but those that did
// at `start`; and keeps triangles from being thinner than `min_height` as
// WithdrawFromThinTriangles does. A vertex that is moved back for both reasons
// counts for both.
WithdrawSummary Untangle(const std::vector<Eigen::Vector3d>& start,
                         double min_height,
                         const Context& context,
                         IndexedMesh* mesh);

// The same for positions that are floats, at `start` too: so are those of
// vertices that were moved back.
WithdrawSummary UntangleFloats(const std::vector<Eigen::Vector3d>& start,
                               double min_height,
                               const Context& context,
                               IndexedMesh* mesh);

}  // namespace octacut
