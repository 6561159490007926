// Holes in masks that are none: shadows and highlights that a threshold or a
// network takes for background. Each would be a tunnel through the object.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/context.h"
#include "core/scene/scene.h"

namespace octacut {

// Background that a mask's object encloses and other views deny.
struct FalseHole {
  size_t view = 0;
  size_t num_pixels = 0;
};

struct FilledScene {
  Scene scene;  // shares images and masks that are as they were
  std::vector<FalseHole> holes;
};

// Fills false holes in the masks. What is seen through a hole is free, and
// other views' silhouettes leave little of the lines of sight through it. A
// hole is false where they leave at least half as much of them as of those
// through the object around it. That is asked again when the holes that were
// found are filled, since views share shadows. Holes that are within
// `mask_tolerance` (pixels of the photographs) of the object everywhere do no
// harm and stay, and larger ones than a twentieth of the object are believed.
// Says what it fills.
FilledScene FillFalseHoles(const Scene& scene,
                           const BoundingCube& cube,
                           double mask_tolerance,
                           const Context& context);

}  // namespace octacut
