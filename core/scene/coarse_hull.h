// A coarse, conservative visual hull inside a box, for finding the region.
#pragma once

#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "core/base/context.h"
#include "core/scene/silhouette_pyramid.h"

namespace octacut {

struct CoarseHull {
  Eigen::AlignedBox3d box;      // world coordinates, not a cube in general
  int resolution = 0;           // cells along each side of the box
  std::vector<uint8_t> inside;  // x fastest; 0 = background in too many views

  size_t CellNumber(const Eigen::Vector3i& cell) const {
    return (size_t(cell.z()) * resolution + cell.y()) * resolution + cell.x();
  }
  Eigen::AlignedBox3d CellBox(const Eigen::Vector3i& cell) const;
};

// Cells of the box that at most `max_denials` silhouettes call background, at
// (2^level)^3 cells; level at least 1.
CoarseHull CarveBox(const std::vector<SilhouettePyramid>& silhouettes,
                    const Eigen::AlignedBox3d& box,
                    int level,
                    const Context& context,
                    size_t max_denials = 0);

// Bounding box in world coordinates of the pieces (26-connected) with at least
// `min_fraction` of the largest one's cells; empty when there is no cell.
Eigen::AlignedBox3d BoundingBoxOfPieces(const CoarseHull& hull,
                                        double min_fraction);

}  // namespace octacut
