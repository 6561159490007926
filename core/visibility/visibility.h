// Which views see a crust voxel: front-facing, within the frame, and not
// hidden behind the current surface.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/grid/face.h"
#include "core/grid/voxel_grid.h"
#include "core/views/view_set.h"
#include "core/visibility/depth_map.h"

namespace octacut {

struct VisibilityOptions {
  // Views at more than this angle (degrees) to the normal do not count. This
  // and the next two are of docs/experiments/visibility.md; not varied alone.
  static constexpr double kMaxAngle = 70;
  // At most this many views per voxel, those of most weight; 2 .. 16.
  int max_views = 8;
  // Depth tolerance in voxels, measured along the normal: what lies in the
  // crust behind the surface is still to be seen. Somewhat more than half of
  // the crust's six voxels.
  double depth_tolerance = 4;
  void Check() const;
};

struct ViewWeight {
  uint16_t view;
  // Cosine of the angle to the normal; times the pixels across a voxel, where
  // the view has less than one.
  float weight;
};

class Visibility {
 public:
  static constexpr int kMaxViews = 16;
  struct Selection {
    std::array<ViewWeight, kMaxViews> views;
    int count = 0;
  };

  // The surface is the cut voxels of `surface`, a labelled crust of the level
  // that is to be seen or of the coarser one; the tolerance is in voxels of
  // `level`. Keeps a reference to `views`.
  static Visibility Estimate(const ViewSet& views,
                             const VoxelGrid& surface,
                             const std::vector<FaceLabels>& labels,
                             int level,
                             const VisibilityOptions& options,
                             const Context& context);

  // The views that see the surface at `point` (unit coordinates) with the
  // given normal, best first; none when the normal is zero.
  Selection Select(const Eigen::Vector3f& point,
                   const Eigen::Vector3f& normal) const;

 private:
  const ViewSet* views_ = nullptr;
  std::vector<DepthMap> depth_maps_;
  float min_cosine_ = 0;
  float tolerance_ = 0;  // unit coordinates, along the normal
  int max_views_ = 0;
  float voxel_ = 0;
};

}  // namespace octacut
