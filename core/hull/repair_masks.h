// The masks as the steps of the reconstruction take them.
#pragma once

#include "core/base/context.h"
#include "core/hull/repaired_scene.h"
#include "core/scene/scene.h"

namespace octacut {

// The scene with the gaps of its masks filled that its points or other views
// show to be false (FillGapsAtPoints, FillFalseGaps) if `fill_false_gaps`, else
// the scene as it is. `mask_tolerance`: pixels of the photographs.
RepairedScene RepairMasks(const Scene& scene,
                          const BoundingCube& cube,
                          double mask_tolerance,
                          bool fill_false_gaps,
                          const Context& context);

}  // namespace octacut
