// Silhouettes of a mesh: how much of each pixel it covers, from 0 to 255
// (CV_8UC1). Pixels at the outline, which differ at their centres from one of
// their eight neighbours, get 4 x 4 rays, the others one. Parts that no pixel's
// centre shows are lost.
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

// As any camera sees it, distorted lenses included.
cv::Mat RenderSilhouette(const RayScene& rays,
                         const cv::Size& size,
                         const PixelRay& ray_of,
                         const Rigid3d& cam_from_world,
                         const Context& context);

// As a pinhole camera sees it whose depth map (RenderDepth) is known: only
// pixels at the outline get rays.
cv::Mat RenderSilhouette(const RayScene& rays,
                         const PinholeCamera& camera,
                         const Rigid3d& cam_from_world,
                         const cv::Mat& depth,
                         const Context& context);

}  // namespace octacut
