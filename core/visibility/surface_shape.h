// Normal and curvature throughout a crust, from an estimate of where its inside
// is.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/grid/face.h"
#include "core/grid/voxel_grid.h"

namespace octacut {

// The shape of the surface through a voxel, parallel to that of the object.
struct SurfaceShape {
  // Outward unit normal. Zero where there is none, deep in the inside.
  Eigen::Vector3f normal;
  // Mean curvature, 1/voxel: positive where the surface is convex.
  float curvature;

  bool operator==(const SurfaceShape&) const = default;
};

// The shape at every voxel, one element per voxel. The normal is minus the
// gradient of `prior` (share of the voxel that is inside) after `blur_steps`
// averagings with the six neighbours; interfaces of the crust count as all
// inside or all outside as they are tied. The curvature is half of the normals'
// divergence.
//
// With `wanted`, one flag a voxel, the shape at those alone, one after the
// other, at a cost that depends on how many there are.
std::vector<SurfaceShape> EstimateSurfaceShape(
    const VoxelGrid& voxels,
    const std::vector<FaceTies>& ties,
    const std::vector<float>& prior,
    int blur_steps,
    const Context& context,
    std::span<const uint8_t> wanted = {});

// `prior` after `blur_steps` averagings with the six neighbours, where
// interfaces of the crust count as they are tied: 0 (outside) .. 1, and a half
// at the surface that it stands for.
std::vector<float> SmoothPrior(const VoxelGrid& voxels,
                               const std::vector<FaceTies>& ties,
                               const std::vector<float>& prior,
                               int blur_steps,
                               const Context& context);

}  // namespace octacut
