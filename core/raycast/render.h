// Pictures of a mesh as a camera sees it: shaded, and its depth.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <opencv2/core/mat.hpp>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/raycast/ray_scene.h"
#include "core/scene/camera.h"

namespace octacut {

struct RenderOptions {
  // Paint with the mesh's vertex colours, where it has them, instead of clay.
  bool use_vertex_colors = false;
  // sRGB in [0, 1]: red, green, blue.
  Eigen::Vector3d clay_color{0.80, 0.76, 0.70};
  // If set, the unit normal that is shaded at a point, such as that of a normal
  // map, instead of the interpolated one.
  std::function<Eigen::Vector3f(const RayScene::Hit&)> normal_at;
};

// The mesh of `rays` in smooth shading (vertex normals of the mesh, or means
// of the triangles' where it has none), 2 x 2 samples per pixel, on white. A
// main light from the upper left behind the camera casts a shadow; less of the
// sky's light reaches hollows. CV_8UC3, BGR, of the camera's size. The same
// bytes for any number of threads.
cv::Mat RenderShaded(const IndexedMesh& mesh,
                     const RayScene& rays,
                     const PinholeCamera& camera,
                     const Rigid3d& cam_from_world,
                     const RenderOptions& options,
                     const Context& context);

// z in the camera's frame at pixel centres, 0 where nothing is hit. CV_32FC1.
cv::Mat RenderDepth(const RayScene& rays,
                    const PinholeCamera& camera,
                    const Rigid3d& cam_from_world,
                    const Context& context);

}  // namespace octacut
