// The sparse points that structure from motion would have found.
#pragma once

#include <vector>

#include "core/benchmark/synthetic/synthetic_scene.h"
#include "core/raycast/ray_scene.h"

namespace octacut {

// At most spec.num_points points spread over the reference by area, with
// those views that see them: inside the frame, facing the camera, not
// occluded. The pixels are where the true cameras see the points, plus
// observation_noise.
std::vector<SyntheticPoint> SampleSparsePoints(const SyntheticScene& scene,
                                               const RayScene& rays);

}  // namespace octacut
