// Normals throughout a crust, from an estimate of where its inside is.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/grid/face.h"
#include "core/grid/voxel_grid.h"

namespace octacut {

// Outward unit normal of every voxel: minus the gradient of `prior` (share of
// the voxel that is inside) after `blur_steps` averagings with the six
// neighbours; interfaces of the crust count as all inside or all outside as
// they are tied. Zero where there is no gradient, deep in the inside.
//
// With `wanted`, one flag a voxel, the normals of those alone, one after the
// other, at a cost that depends on how many there are.
std::vector<Eigen::Vector3f> EstimateNormals(
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
