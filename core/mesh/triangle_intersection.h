// Whether two triangles meet elsewhere than where a mesh joins them. Exact.
#pragma once

#include <array>
#include <Eigen/Core>

namespace octacut {

using TriangleCorners = std::array<Eigen::Vector3d, 3>;

// No area at all: the corners are collinear.
bool IsDegenerate(const TriangleCorners& triangle);

// Corners at the same place are joined, whatever their indices. True when the
// closed triangles have a point in common that is not part of the vertex or
// edge they share: they cross, touch, overlap in a plane, or are folded onto
// each other. Two triangles with the same three corners overlap. Neither may
// be degenerate.
bool TrianglesIntersect(const TriangleCorners& first,
                        const TriangleCorners& second);

}  // namespace octacut
