// Normal maps: of a mesh, and of a depth map by itself.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/raycast/ray_scene.h"
#include "core/scene/camera.h"

namespace octacut {

// Two images of the same size: depth CV_32FC1, along the optical axis, 0 for
// none; normals CV_32FC3, unit vectors in the camera's frame that face the
// camera, 0 where there is no depth.
struct DepthAndNormals {
  cv::Mat depth;
  cv::Mat normals;
};

// What the camera sees of the mesh at the pixels' centres. `rays` is of the
// mesh. Back faces count as surface too.
DepthAndNormals RenderDepthAndNormals(const IndexedMesh& mesh,
                                      const RayScene& rays,
                                      const PinholeCamera& camera,
                                      const Rigid3d& cam_from_world,
                                      const Context& context);

// Fits a plane to the points of (2 * radius + 1)^2 pixels whose depth differs
// from the middle's by at most 3 * (`radius` + 1) pixel sizes. Depths whose
// plane is not determined (fewer than six points) are dropped.
DepthAndNormals FitNormals(const cv::Mat& depth,
                           const PinholeCamera& camera,
                           int radius,
                           const Context& context);

}  // namespace octacut
