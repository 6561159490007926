// The sparse points that structure from motion would have found.
#pragma once

#include <vector>

#include "core/benchmark/synthetic/render_view.h"
#include "core/benchmark/synthetic/synthetic_scene.h"

namespace octacut {

// At most spec.num_points points spread over the object by area, and half as
// many each over the stand and over what the views show of a room that does not
// stand still with the camera, with those views that see them: inside the
// frame, facing the camera, not occluded. The pixels are where the true cameras
// see the points, plus observation_noise. `subject` is what the scene was
// rendered from.
std::vector<SyntheticPoint> SampleSparsePoints(const SyntheticScene& scene,
                                               const RenderSubject& subject);

}  // namespace octacut
