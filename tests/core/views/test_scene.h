// Small synthetic scenes with prepared views, for the tests of the steps.
#pragma once

#include <string>
#include <tuple>
#include <utility>

#include "core/scene/region.h"
#include "core/views/view_set.h"
#include "tests/core/benchmark/synthetic/quick_scene.h"
#include "tests/core/views/random_views.h"
#include "tests/core/views/render_once.h"

namespace octacut::testing {

struct TestScene {
  SyntheticScene synthetic;
  Scene scene;
  Region region;  // 5 % of the object's size free on each side
  ViewSet views;

  double Value(const Eigen::Vector3d& unit) const {  // < 0 inside; world units
    return synthetic.object.shape(ToWorld(region.cube, unit));
  }
  double VoxelSize(int level) const { return region.cube.VoxelSize(level); }
  // Size of a pixel at the object, in world units.
  double PixelSize() const {
    const View& view = scene.views[0];
    return (view.Center() - region.cube.Center()).norm() / view.camera.fx;
  }
  static Eigen::AlignedBox3f UnitBox() {
    return {Eigen::Vector3f::Zero(), Eigen::Vector3f::Ones()};
  }
};

inline TestScene MakeTestScene(SyntheticScene synthetic) {
  TestScene test;
  test.synthetic = std::move(synthetic);
  test.scene = ToScene(test.synthetic);
  const Eigen::AlignedBox3d& box = test.synthetic.object.shape.box;
  test.region.cube.edge = 1.1 * box.sizes().maxCoeff();
  test.region.cube.min_corner =
      box.center() - Eigen::Vector3d::Constant(test.region.cube.edge / 2);
  test.region.box =
      Eigen::AlignedBox3d(test.region.cube.min_corner,
                          test.region.cube.min_corner +
                              Eigen::Vector3d::Constant(test.region.cube.edge));
  test.views = PrepareViews(test.scene, test.region.cube, Context(2));
  return test;
}
inline TestScene MakeTestScene(const SceneSpec& spec) {
  return MakeTestScene(MakeScene(spec, Context(2)));
}

// The whole cube is in sight, so that no phantoms are left at its corners.
inline SceneSpec TestSpec(const std::string& object,
                          int width = 160,
                          int height = 120,
                          int num_views = 20) {
  SceneSpec spec = QuickScene(object, width, height, num_views);
  spec.rig.fill = 0.65;
  spec.num_points = 0;
  spec.reference.resolution = 48;
  spec.lighting.num_samples = 2;
  return spec;
}
inline TestScene MakeTestScene(const std::string& object,
                               int width = 160,
                               int height = 120,
                               int num_views = 20) {
  return MakeTestScene(
      RenderOnce(std::tuple(object, width, height, num_views),
                 [](const auto& key) { return std::apply(TestSpec, key); }));
}

// A cup, a unit wide, in photographs from the side and from above.
inline SceneSpec OpenCupSpec(double depth) {
  SceneSpec spec = TestSpec("cup", 240, 180, 32);
  spec.parameters.cup_depth = depth;
  spec.rig.kind = RigKind::kRings;
  spec.rig.min_elevation = -10;
  spec.rig.max_elevation = 75;
  return spec;
}
inline TestScene MakeOpenCup(double depth) {
  return MakeTestScene(
      RenderOnce(depth, [](double d) { return OpenCupSpec(d); }));
}

}  // namespace octacut::testing
