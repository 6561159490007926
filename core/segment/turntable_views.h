// What photographs of a turntable tell once cameras and plate are known.
#pragma once

#include "core/base/context.h"
#include "core/segment/search_region.h"
#include "core/segment/segment_object.h"

namespace octacut {

// Sets `above_plate` of the views of a turntable; `input` has a floor.
//
// If the turntable's masks contradict one another (ContradictedPart), parts of
// the object look like the background behind them and were taken for it. There
// is a warning, and `labels` and `is_turntable` of these views are cleared, so
// that the object is found from colours and the other views alone.
void UseTurntable(const SearchRegion& region,
                  const Context& context,
                  SegmentationInput* input);

}  // namespace octacut
