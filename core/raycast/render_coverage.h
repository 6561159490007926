// How much of each pixel a mesh covers, in the time of few rays.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/base/context.h"
#include "core/raycast/ray_scene.h"
#include "core/scene/camera.h"

namespace octacut {

// As RenderMask, but only pixels at the outline get samples x samples rays:
// those that differ in `depth` (of RenderDepth, the same camera) from one of
// their eight neighbours. Parts that no pixel's centre shows are lost. CV_8UC1.
cv::Mat RenderCoverage(const RayScene& rays,
                       const PinholeCamera& camera,
                       const Rigid3d& cam_from_world,
                       const cv::Mat& depth,
                       const Context& context,
                       int samples = 4);

}  // namespace octacut
