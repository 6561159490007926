// Gaps in masks that other views show to be object.
#pragma once

#include "core/base/context.h"
#include "core/hull/repaired_scene.h"
#include "core/scene/scene.h"

namespace octacut {

// Fills false gaps in the masks: background that an object encloses, or a bay
// of its border. What is seen through a gap is free, and other views'
// silhouettes leave little of the lines of sight through its middle. A gap is
// false where they leave half as much of them (seven tenths, of a bay) as of
// those through the object around it. That is asked again when the gaps that
// were found are filled, since views share shadows. Enclosed gaps that are
// within `mask_tolerance` (pixels of the photographs) of the object everywhere,
// and bays within twice that, do no harm and stay; larger ones than a twentieth
// of the object are left as they are. Logs what it fills.
RepairedScene FillFalseGaps(const Scene& scene,
                            const BoundingCube& cube,
                            double mask_tolerance,
                            const Context& context);

}  // namespace octacut
