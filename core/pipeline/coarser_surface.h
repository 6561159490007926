// The surface of the coarser level in the voxels of a crust.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/crust/crust.h"
#include "core/visibility/surface_shape.h"

namespace octacut {

// How far each voxel of `crust` is inside of it, 0 .. 1, without the steps of
// the coarser voxels, which four averagings take away.
inline std::vector<float> CoarserInside(const Crust& crust,
                                        const Context& context) {
  constexpr int kBlurSteps = 4;
  return SmoothPrior(
      crust.voxels, crust.ties, crust.prior, kBlurSteps, context);
}

}  // namespace octacut
