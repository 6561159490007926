// Light on a synthetic object: distant discs that cast soft shadows, and an
// even sky that reaches into cavities less.
//
// Both are computed at the vertices of the (fine) reference mesh and
// interpolated: shadows free of sampling noise, the same in all views when
// the light stands still.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/raycast/ray_scene.h"

namespace octacut {

struct AreaLight {
  // Toward the light; need not be of unit length. In the frame of the object,
  // or of the camera (x right, y down, z forward) when fixed to that.
  Eigen::Vector3d direction{0, 0, 1};
  double angular_radius = 8;  // degrees; 0: hard shadows
  Eigen::Vector3f color{1, 1, 1};
};

struct LightingOptions {
  std::vector<AreaLight> lights{{{0.55, -0.5, 0.8}, 9, {1.30f, 1.22f, 1.10f}},
                                {{-0.8, 0.3, 0.35}, 14, {0.30f, 0.34f, 0.40f}}};
  Eigen::Vector3f ambient{0.42f, 0.43f, 0.46f};
  // The lights turn with the camera, as on a turntable.
  bool fixed_to_camera = false;
  // Strength and sharpness of highlights (Blinn-Phong); 0: matte.
  double specular = 0;
  double shininess = 40;
  int num_samples = 16;  // rays per vertex for each light and for the sky

  void Check() const;  // throws OptionError
};

// The fraction of a light's disc that each vertex sees, in [0, 1].
// `direction` in world coordinates, `angular_radius` in degrees.
std::vector<float> BakeVisibility(const IndexedMesh& mesh,
                                  const RayScene& rays,
                                  const Eigen::Vector3d& direction,
                                  double angular_radius,
                                  int num_samples,
                                  const Context& context);

// The cosine-weighted fraction of the hemisphere over each vertex that is not
// hidden by the object itself, in [0, 1].
std::vector<float> BakeOpenness(const IndexedMesh& mesh,
                                const RayScene& rays,
                                int num_samples,
                                const Context& context);

}  // namespace octacut
