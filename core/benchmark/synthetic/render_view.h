// Photographs of a synthetic object: image and antialiased silhouette.
#pragma once

#include <cstddef>
#include <limits>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/context.h"
#include "core/benchmark/synthetic/lighting.h"
#include "core/benchmark/synthetic/material.h"
#include "core/benchmark/synthetic/rig.h"
#include "core/benchmark/synthetic/texture.h"
#include "core/mesh/indexed_mesh.h"
#include "core/raycast/ray_scene.h"

namespace octacut {

enum class BackgroundKind {
  kPlain,  // a mild gradient from the image's top to its bottom
  kRoom,   // a far textured sphere that stands still around the object
};

struct BackgroundOptions {
  BackgroundKind kind = BackgroundKind::kPlain;
  // Linear: red, green, blue.
  Eigen::Vector3f top{0.42f, 0.45f, 0.50f};
  Eigen::Vector3f bottom{0.20f, 0.21f, 0.23f};
  double room_radius = 8;         // in radii of the object's bounding sphere
  double room_texture_scale = 1;  // the same
  // The room is around the camera and stands still as it does, as behind a
  // turntable.
  bool fixed_to_camera = false;
};

// What the renderer needs of an object. The mesh has vertex normals; mesh and
// rays outlive this.
struct RenderSubject {
  const IndexedMesh& mesh;
  const RayScene& rays;
  TextureOptions texture;
  LightingOptions lighting;
  BackgroundOptions background;
  Finish finish = {};
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  // bounding sphere
  double radius = 1;
  // Triangles from this number on are the stand, which is not in the mask.
  size_t num_object_triangles = std::numeric_limits<size_t>::max();
  TextureOptions stand_texture = {};
  // Values of the vertices; visibility only for lights fixed to the object.
  std::vector<float> openness = {};
  std::vector<std::vector<float>> visibility = {};
};

// Bakes what does not depend on the camera. The subject mirrors nothing; a
// finish may be given to it afterwards.
RenderSubject MakeRenderSubject(const IndexedMesh& mesh,
                                const RayScene& rays,
                                const TextureOptions& texture,
                                const LightingOptions& lighting,
                                const BackgroundOptions& background,
                                const Context& context);

// Where a ray from inside the room meets its wall. World coordinates.
Eigen::Vector3d RoomWall(const RenderSubject& subject,
                         const Eigen::Vector3d& origin,
                         const Eigen::Vector3d& ray);

struct RenderedView {
  cv::Mat image;  // CV_8UC3, BGR, sRGB
  cv::Mat mask;   // CV_8UC1, coverage by the object, without the stand, from 0
                  // to 255
};

RenderedView RenderView(const RenderSubject& subject,
                        const Lens& lens,
                        const Rigid3d& cam_from_world,
                        const Context& context);

}  // namespace octacut
