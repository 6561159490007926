// The depths of a score volume. For core/evidence alone.
#pragma once

#include "core/evidence/depth_sweep.h"
#include "core/evidence/score_volume.h"
#include "core/evidence/sweep_view.h"

namespace octacut {

// Each ray's best plane, refined between planes, where its score is at least
// `min_score` and stands out from every other peak.
SweptDepthMap PickDepths(const SweepView& view,
                         const ScoreVolume& volume,
                         float min_score);

}  // namespace octacut
