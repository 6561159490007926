// Whether a mask is cut too close, by what other views have found: its border
// shows as object what it should, or surfaces lie outside of it.
#pragma once

#include <vector>

#include "core/base/context.h"
#include "core/evidence/depth_sweep.h"
#include "core/views/view_set.h"

namespace octacut {

// Masks of at most this confidence do not bound the hull.
inline constexpr float kReliableMask = 0.5f;

// For each view 1 where its mask can be relied upon, 0 where surfaces end
// beyond the mask's border rather than at it. Points of the depth maps (one a
// view) that other views have found are counted within mask_tolerance of the
// border, outside and inside: depths are not exact, so that a third lies
// outside of masks that are right, and half and more of masks that are too
// small by the tolerance. A view without such points is relied upon.
std::vector<float> EstimateMaskConfidence(
    const ViewSet& views,
    const std::vector<SweptDepthMap>& maps,
    const Context& context);

}  // namespace octacut
