// Gaps in masks that are none: shadows and highlights that a threshold or a
// network takes for background. Each would be a tunnel through the object or a
// bite out of it.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/context.h"
#include "core/scene/scene.h"

namespace octacut {

// Background that a mask's object encloses, or a bay of its border, that other
// views deny.
struct FalseGap {
  size_t view = 0;
  size_t num_pixels = 0;
};

struct RepairedScene {
  Scene scene;  // shares images and masks that are as they were
  std::vector<FalseGap> gaps;
};

// The first one of those with most pixels; there must be one.
const FalseGap& LargestGap(const RepairedScene& filled);

// Fills false gaps in the masks. What is seen through a gap is free, and other
// views' silhouettes leave little of the lines of sight through its middle. A
// gap is false where they leave half as much of them (seven tenths, of a bay)
// as of those through the object around it. That is asked again when the gaps
// that were found are filled, since views share shadows. Enclosed gaps that are
// within `mask_tolerance` (pixels of the photographs) of the object everywhere,
// and bays within twice that, do no harm and stay; larger ones than a twentieth
// of the object are left as they are. Logs what it fills.
RepairedScene FillFalseGaps(const Scene& scene,
                            const BoundingCube& cube,
                            double mask_tolerance,
                            const Context& context);

// The scene with the gaps of its masks filled that its points or other views
// show to be false (FillGapsAtPoints, FillFalseGaps) if `fill_false_gaps`, else
// the scene as it is.
RepairedScene RepairMasks(const Scene& scene,
                          const BoundingCube& cube,
                          double mask_tolerance,
                          bool fill_false_gaps,
                          const Context& context);

}  // namespace octacut
