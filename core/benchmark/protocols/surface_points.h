// Clouds of points as the protocols of benchmarks prepare them.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

// The points of a cloud as they are. For a mesh, the vertices that triangles
// use and points spread evenly over its surface, one for each square of side
// `spacing`: benchmarks of clouds would otherwise judge the vertices alone, and
// large triangles not at all. Throws InputError where that needs more than
// kMaxSurfacePoints.
inline constexpr double kMaxSurfacePoints = 2e8;  // 5 GB
std::vector<Eigen::Vector3d> PointsOfSurface(const IndexedMesh& mesh,
                                             double spacing,
                                             uint64_t seed,
                                             const Context& context);

// The vertices that triangles use; all points of a cloud.
std::vector<Eigen::Vector3d> UsedPoints(const IndexedMesh& mesh);

// Visits the points in a random order and removes all others within `distance`
// of each point that is still there, as DTU's evaluation does.
std::vector<Eigen::Vector3d> ThinPoints(std::vector<Eigen::Vector3d> points,
                                        double distance,
                                        uint64_t seed,
                                        const Context& context);

// The mean of the points in each cell of a grid, which begins half a cell
// below the smallest coordinates, as Open3D's voxel_down_sample does. In the
// order of the cells.
std::vector<Eigen::Vector3d> AverageInCells(
    const std::vector<Eigen::Vector3d>& points, double cell_size);

// The cell of a grid of `cell_size` in which a point lies; `shift` moves the
// grid by that part of a cell.
using CellKey = std::array<int64_t, 3>;
CellKey CellOf(const Eigen::Vector3d& point,
               double cell_size,
               const Eigen::Vector3d& shift);

}  // namespace octacut
