// The light that a point of a synthetic object sends to the eye.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/benchmark/synthetic/render_view.h"
#include "core/raycast/ray_scene.h"
#include "core/scene/camera.h"

namespace octacut {

// For one view, since lights may be fixed to the camera. Outlived by the
// subject.
class SurfaceShader {
 public:
  SurfaceShader(const RenderSubject& subject,
                const Rigid3d& cam_from_world,
                const Context& context);

  // Linear radiance along the ray back from where it hits. The ray is in world
  // coordinates and need not be of unit length.
  Eigen::Vector3f operator()(const RayScene::Hit& hit,
                             const Eigen::Vector3d& origin,
                             const Eigen::Vector3d& ray) const;

 private:
  struct SurfacePoint {
    const RayScene::Hit& hit;
    Eigen::Vector3d position;
    Eigen::Vector3f normal;  // interpolated, of unit length
    Eigen::Vector3f to_eye;  // the same
  };

  SurfacePoint PointAt(const RayScene::Hit& hit,
                       const Eigen::Vector3d& origin,
                       const Eigen::Vector3d& ray) const;
  // The mean over the triangle's corners, weighted as the hit is near them.
  template <typename Values>
  auto Interpolate(const Values& values, const RayScene::Hit& hit) const;
  bool IsObject(const RayScene::Hit& hit) const {
    return hit.triangle < subject_.num_object_triangles;
  }
  // What texture and lights make of it.
  Eigen::Vector3f Scattered(const SurfacePoint& point) const;
  // What it mirrors, the object itself included `num_bounces` times.
  Eigen::Vector3f Mirrored(const SurfacePoint& point, int num_bounces) const;
  Eigen::Vector3f Sent(const SurfacePoint& point, int num_bounces) const;

  const RenderSubject& subject_;
  Eigen::Matrix3f room_from_world_;
  double ray_offset_;
  std::vector<Eigen::Vector3f> light_directions_;
  std::vector<std::vector<float>> view_visibility_;
};

}  // namespace octacut
