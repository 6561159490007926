// Pits of a cut that nothing but chance has made.
//
// Where hardly any view finds the surface of a plain object, a few wrong depths
// of one view open a pit, and not even from the side on which that view is.
// The views that see into it do not agree about it at all; about a hollow that
// photographs have opened they agree as a whole (docs/experiments/dents.md).
#pragma once

#include <cstdint>
#include <vector>

#include "core/pipeline/surface_agreement.h"
#include "core/raycast/ray_scene.h"

namespace octacut {

// For each vertex of the cut's mesh, 1 where it is in such a pit: a connected
// part of the surface that lies deep in the visual hull `hull`, of which two
// views see most, and about which the views do not agree in the mean. `means`
// are MeansAround of the cut's agreement, and `voxel` is the cut's; unit
// coordinates.
std::vector<uint8_t> FindUnfoundedPits(const MeasuredSurface& cut,
                                       const std::vector<float>& means,
                                       const RayScene& hull,
                                       double voxel,
                                       const Context& context);

}  // namespace octacut
