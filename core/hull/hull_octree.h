// Adaptive refinement of the root cube against all silhouettes.
#pragma once

#include <cstddef>
#include <Eigen/Geometry>
#include <vector>

#include "core/base/context.h"
#include "core/base/morton.h"
#include "core/views/view_set.h"

namespace octacut {

// Voxels of `level` that may hold the hull's surface, and those voxels (of
// this or a coarser level) that lie inside with all their descendants.
struct HullOctree {
  int level = 0;
  std::vector<MortonCode> mixed;                // ascending
  std::vector<std::vector<MortonCode>> inside;  // of levels 0 .. level
  std::vector<size_t> tested_voxels;            // of levels 0 .. level

  // Whether a voxel of `level` is inside as a descendant of one of `inside`.
  bool IsInside(MortonCode code) const;
  bool IsEmpty() const;
};

// Conservative footprint tests down to `level`; `box` (unit coordinates)
// clips. What is within a view's mask_tolerance of its object is mixed. Throws
// InputError when nothing is left.
HullOctree RefineHull(const ViewSet& views,
                      const Eigen::AlignedBox3f& box,
                      int level,
                      const Context& context);

}  // namespace octacut
