// Triangles that fill polygons with holes and use every corner of theirs.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

namespace octacut {

// Corners in order; a loop with the inside to its left.
using PolygonLoop = std::vector<uint32_t>;

// Triangles, counter-clockwise, of the area that lies to the left of all loops:
// outer ones run counter-clockwise, holes clockwise. Loops must not meet. Each
// edge of a loop is an edge of one triangle, also where corners are in line, so
// that what joins the loops is closed; triangles without area are not made.
// By cutting ears; time grows with the square of the number of corners. Empty
// where loops do meet and this cannot be done.
std::vector<std::array<uint32_t, 3>> TrianglesOfLoops(
    const std::vector<Eigen::Vector2d>& points,
    const std::vector<PolygonLoop>& loops);

}  // namespace octacut
