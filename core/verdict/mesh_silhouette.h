// The silhouette of a mesh in a view, at the cost of few rays.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/raycast/ray_scene.h"
#include "core/views/view_set.h"

namespace octacut {

// 255 where the ray through a pixel's centre hits the mesh of `rays` (unit
// coordinates), 0 elsewhere; CV_8UC1 of the view's size. Far from the border of
// the view's own silhouette one ray stands for 2 x 2 pixels, so that only holes
// of a single pixel can be overlooked, and only there.
cv::Mat RenderHits(const RayScene& rays, const PreparedView& view);

}  // namespace octacut
