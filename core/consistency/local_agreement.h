// Where photo-consistency shows a surface, and where it says nothing.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/grid/voxel_grid.h"

namespace octacut {

// A true surface is a sheet of voxels of low phi across the crust, so that the
// mean of phi over a voxel and those around it is low somewhere near. Where a
// surface is plain, or mirrors something else in every view, low values are
// scattered and such means stay near neutral or above.
struct LocalAgreement {
  // One per voxel, 0 .. 1: whether the views agree about a surface near it.
  std::vector<float> near_voxel;
  // One per voxel, 0 .. 1: whether they do in most of what is around it, over
  // its brick and the bricks within three steps.
  std::vector<float> in_region;
};

// `phi` is the photo-consistency of the voxels of a crust, one per voxel.
LocalAgreement EstimateLocalAgreement(const VoxelGrid& voxels,
                                      const std::vector<float>& phi,
                                      const Context& context);

}  // namespace octacut
