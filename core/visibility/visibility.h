// Which views see a crust voxel: front-facing, within the frame, and not
// hidden behind the current surface.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/cut/octahedral_cut.h"
#include "core/grid/voxel_grid.h"
#include "core/views/view_set.h"
#include "core/visibility/depth_map.h"

namespace octacut {

struct VisibilityOptions {
  // Views at more than this angle (degrees) to the normal do not count.
  double max_angle = 70;
  // At most this many views a voxel, those most nearly frontal; 2 .. 16.
  int max_views = 8;
  // Depth tolerance in voxels, measured along the normal: what lies in the
  // crust behind the surface is still to be seen.
  double depth_tolerance = 4;
  void Check() const;
};

struct ViewWeight {
  uint16_t view;
  float weight;  // cosine of the angle to the normal
};

class Visibility {
 public:
  static constexpr int kMaxViews = 16;
  struct Selection {
    std::array<ViewWeight, kMaxViews> views;
    int count = 0;
  };

  // The surface is the cut voxels of `surface` (a labelled crust, of this
  // level or the coarser one); `normals` are those of the crust's voxels.
  static Visibility Estimate(const ViewSet& views,
                             const VoxelGrid& surface,
                             const std::vector<FaceLabels>& labels,
                             int level,
                             std::vector<Eigen::Vector3f> normals,
                             const VisibilityOptions& options,
                             const Context& context);

  const Eigen::Vector3f& Normal(size_t voxel) const { return normals_[voxel]; }
  // The views that see the voxel at `point` (unit coordinates), best first.
  Selection Select(size_t voxel, const Eigen::Vector3f& point) const;

 private:
  bool Sees(size_t view, const Eigen::Vector3f& point, float cosine) const;

  const ViewSet* views_ = nullptr;
  std::vector<DepthMap> depth_maps_;
  std::vector<Eigen::Vector3f> normals_;
  float min_cosine_ = 0;
  float tolerance_ = 0;  // unit coordinates, along the normal
  int max_views_ = 0;
};

}  // namespace octacut
