// Synthetic scenes for quick tests.
#pragma once

#include <algorithm>
#include <string>

#include "core/base/error.h"
#include "core/benchmark/synthetic/synthetic_scene.h"
#include "core/scene/scene.h"

namespace octacut {

// A spec with an object of MakeObject: fewer, smaller images and a coarser
// reference than the defaults, which are for 36 cameras at 1024 x 768; all else
// equal.
inline SceneSpec QuickScene(const std::string& object,
                            int width = 160,
                            int height = 120,
                            int num_views = 16) {
  SceneSpec spec;
  spec.object = object;
  spec.rig.width = width;
  spec.rig.height = height;
  spec.rig.num_views = num_views;
  spec.reference.resolution = 64;
  // Details of the texture must span pixels to be of use.
  spec.texture.scale *= std::max(1.0, 400.0 / width);
  spec.lighting.num_samples = 8;
  spec.num_points = 300;
  return spec;
}

// The scene as the core's steps take it, with the points on the object. Images
// are shared, not copied. Throws InputError when the lens distorts.
inline Scene ToScene(const SyntheticScene& synthetic) {
  Scene scene;
  for (const SyntheticView& view : synthetic.views) {
    if (view.lens.k1 != 0) {
      throw InputError(view.name + " is distorted");
    }
    scene.views.push_back({view.name,
                           view.lens.camera,
                           view.cam_from_world,
                           view.image,
                           view.mask,
                           cv::Mat()});
  }
  for (const SyntheticPoint& point : synthetic.points) {
    if (point.on_object) {
      scene.points.push_back(point.position);
    }
  }
  return scene;
}

}  // namespace octacut
