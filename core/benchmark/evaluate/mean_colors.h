// Colours of a mesh's vertices from the photographs.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/raycast/ray_scene.h"
#include "core/scene/scene.h"

namespace octacut {

// For each point of the surface of `rays` the mean colour (red, green, blue)
// over the three views that see it most from the front, or fewer; grey where
// no view sees it. `normals` of the points. The views need images. The same
// colours for any number of threads.
std::vector<std::array<uint8_t, 3>> MeanColors(
    const std::vector<Eigen::Vector3d>& points,
    const std::vector<Eigen::Vector3f>& normals,
    const RayScene& rays,
    const std::vector<View>& views,
    const Context& context);

}  // namespace octacut
