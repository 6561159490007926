// Whole synthetic scenes: an object known exactly, photographs of it with
// silhouettes, cameras, sparse points, and the mesh that a reconstruction is
// judged by. Used by tests, benchmarks and the bundled example alike.
//
// World frame: the object's own, z upward, about two units in size. A given
// mesh is moved there and scaled: its bounding box is around the origin and has
// a longest side of two units.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/context.h"
#include "core/benchmark/synthetic/degrade.h"
#include "core/benchmark/synthetic/material.h"
#include "core/benchmark/synthetic/objects.h"
#include "core/benchmark/synthetic/polygonize.h"
#include "core/benchmark/synthetic/render_view.h"
#include "core/benchmark/synthetic/rig.h"
#include "core/mesh/indexed_mesh.h"
#include "core/scene/scene.h"

namespace octacut {

// A round plate that the object stands on and turns with. It is in the
// photographs, not in the masks.
struct StandOptions {
  bool is_there = false;
  // Relative to that of the smallest upright cylinder around the object, whose
  // axis it shares.
  double radius = 1.15;
  TextureOptions texture{.kind = TextureKind::kMarble,
                         .scale = 0.5,
                         .color = {0.42f, 0.27f, 0.15f},
                         .seed = 5};

  void Check() const;  // throws OptionError
};

struct SceneSpec {
  std::string object = "example";  // see MakeObject
  // Photographed instead of `object`: closed and oriented outward. Its normals
  // and colours are not used.
  std::optional<IndexedMesh> mesh;
  ObjectParameters parameters;
  PolygonizeOptions reference;
  RigOptions rig;
  // Other kinds than kDiffuse replace texture and lights; see MakeMaterial.
  MaterialKind material = MaterialKind::kDiffuse;
  TextureOptions texture;
  LightingOptions lighting;
  // A room stands still with the camera of a turntable.
  BackgroundOptions background;
  StandOptions stand;
  DegradeOptions degrade;
  // Sparse points on the object; those that fewer than two views see are left
  // out. Stand and room, as far as they turn with the object, get half as many
  // each.
  int num_points = 2000;
  // Standard deviation of the observations of sparse points, in pixels.
  double observation_noise = 0;
  uint64_t seed = 0;
  std::string image_extension = ".jpg";  // of the views' names

  void Check() const;  // throws OptionError
};

struct SyntheticView {
  std::string name;
  Lens lens;
  // As a sparse model would report it, and as the image was made.
  Rigid3d cam_from_world;
  Rigid3d true_cam_from_world;
  cv::Mat image;  // CV_8UC3, BGR, distorted as the lens says
  cv::Mat mask;   // CV_8UC1, coverage, the same geometry
};

struct SyntheticPoint {
  struct Observation {
    uint32_t view;          // index into SyntheticScene::views
    Eigen::Vector2d pixel;  // (0, 0) is the image's top-left corner
  };
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  bool on_object = true;                  // not on the surroundings
  std::array<uint8_t, 3> color;           // red, green, blue
  std::vector<Observation> observations;  // at least two, ordered by view
};

struct SyntheticScene {
  SceneSpec spec;
  SyntheticObject object;  // of a given mesh without a shape
  IndexedMesh reference;   // with vertex normals and colours
  std::vector<SyntheticView> views;
  std::vector<SyntheticPoint> points;
  // On a turntable: photographs without the object, the stand turned.
  std::vector<cv::Mat> empty_set;
};

// The same bytes for any number of threads. Throws OptionError when a camera is
// below the plane of the stand, which would hide the object from it.
SyntheticScene MakeScene(const SceneSpec& spec, const Context& context);

}  // namespace octacut
