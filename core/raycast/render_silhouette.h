// The silhouette of a mesh as any camera sees it, distorted lenses included.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "core/base/context.h"
#include "core/raycast/ray_scene.h"
#include "core/scene/camera.h"

namespace octacut {

// The ray of a place in the picture, in the camera's frame; empty where the
// lens shows nothing. Called from several threads.
using PixelRay =
    std::function<std::optional<Eigen::Vector3d>(const Eigen::Vector2d& pixel)>;

// Coverage of each pixel by the mesh from 0 to 255. Pixels at the outline,
// which differ at their centres from one of their eight neighbours, get 4 x 4
// rays, the others one. Parts that no pixel's centre shows are lost. CV_8UC1.
cv::Mat RenderSilhouette(const RayScene& rays,
                         const cv::Size& size,
                         const PixelRay& ray_of,
                         const Rigid3d& cam_from_world,
                         const Context& context);

}  // namespace octacut
