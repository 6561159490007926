#include "core/hull/visual_hull.h"

#include <algorithm>

#include "core/base/check_option.h"
#include "core/grid/morphology.h"

namespace octacut {

void VisualHullOptions::Check() const {
  CheckOption(hull_level >= 2 && hull_level <= kMaxLevel,
              "hull_level",
              hull_level,
              "must be in 2 .. 10");
}

VisualHull ComputeVisualHull(const HullOctree& octree) {
  VisualHull hull;
  hull.summary.tested_voxels = octree.tested_voxels;
  hull.voxels = VoxelGrid::FromCodes(octree.level, octree.mixed);
  for (int level = 0; level <= octree.level; ++level) {
    VoxelGrid inside = VoxelGrid::FromCodes(level, octree.inside[level]);
    while (inside.Level() < octree.level) {
      inside = Children(inside);
    }
    hull.voxels = Union(hull.voxels, inside);
  }
  hull.summary.num_voxels = hull.voxels.Size();
  return hull;
}

VisualHull ComputeVisualHull(const ViewSet& views,
                             const Eigen::AlignedBox3f& box,
                             const VisualHullOptions& options,
                             const Context& context) {
  options.Check();
  return ComputeVisualHull(RefineHull(views, box, options.hull_level, context));
}

bool ShowsBackground(const PreparedView& view, const Eigen::Vector3f& point) {
  const std::optional<ProjectedPoint> p = view.projection.Project(point);
  return p && view.silhouette.Coverage(p->u, p->v) < kObjectCoverage;
}

bool IsInsideHull(const ViewSet& views,
                  const Eigen::AlignedBox3f& box,
                  const Eigen::Vector3f& point) {
  if (!box.contains(point)) {
    return false;
  }
  return std::none_of(views.begin(), views.end(), [&](const auto& view) {
    return ShowsBackground(view, point);
  });
}

}  // namespace octacut
