// Visual hull by adaptive refinement of the root cube [HK06 section 3].
#pragma once

#include <cstddef>
#include <Eigen/Geometry>
#include <vector>

#include "core/base/context.h"
#include "core/grid/voxel_grid.h"
#include "core/hull/hull_octree.h"
#include "core/views/view_set.h"

namespace octacut {

struct VisualHullOptions {
  static constexpr int kMaxLevel = 10;
  int hull_level = 7;  // l0: the hull has (2^l0)^3 voxels; 2 .. kMaxLevel
  void Check() const;
};

struct VisualHullSummary {
  std::vector<size_t> tested_voxels;  // of levels 0 .. hull_level
  size_t num_voxels = 0;
};

struct VisualHull {
  // Every voxel whose footprint is within mask_tolerance of a pixel of the
  // object in all views that see it whole. Conservative: a voxel that the
  // object touches is in it, as far as the silhouettes are right.
  VoxelGrid voxels;
  VisualHullSummary summary;
};

VisualHull ComputeVisualHull(const HullOctree& octree);

// `box` (unit coordinates of the root cube) clips the hull. Throws InputError
// when nothing is left.
VisualHull ComputeVisualHull(const ViewSet& views,
                             const Eigen::AlignedBox3f& box,
                             const VisualHullOptions& options,
                             const Context& context);

// Whether the view has a point (unit coordinates) before it, within its frame
// and beside its object.
bool ShowsBackground(const PreparedView& view, const Eigen::Vector3f& point);

// Whether a point (unit coordinates) lies in the hull: object in every view
// whose frame it projects to. Exact at sub-pixel scale, not conservative.
bool IsInsideHull(const ViewSet& views,
                  const Eigen::AlignedBox3f& box,
                  const Eigen::Vector3f& point);

}  // namespace octacut
