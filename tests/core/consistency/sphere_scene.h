// A textured sphere with a thick shell of voxels around its surface, and their
// true shapes.
#pragma once

#include <vector>

#include "core/consistency/photo_consistency.h"
#include "tests/core/crust/labeled_shapes.h"
#include "tests/core/views/test_scene.h"

namespace octacut::testing {

struct SphereScene {
  static constexpr int kLevel = 6;
  static constexpr double kRadius = 0.8;  // world units
  TestScene test;
  LabeledVoxels surface;
  VoxelGrid shell;
  std::vector<SurfaceShape> shapes;  // of the shell

  // Voxels above the true surface.
  double Height(MortonCode code) const {
    const Eigen::Vector3d center =
        VoxelCenter(DecodeMorton(code), kLevel).cast<double>();
    return (ToWorld(test.region.cube, center).norm() - kRadius) /
           test.VoxelSize(kLevel);
  }

  Visibility EstimateVisibility(const ViewSet& views) const {
    return Visibility::Estimate(views,
                                surface.voxels,
                                surface.labels,
                                kLevel,
                                VisibilityOptions(),
                                Context(2));
  }
  PhotoConsistency Estimate(const ConsistencyOptions& options,
                            const ViewSet& views,
                            const Context& context) const {
    return EstimateConsistency(
        views, shell, shapes, EstimateVisibility(views), options, context);
  }
  PhotoConsistency Estimate(const ConsistencyOptions& options,
                            const ViewSet& views) const {
    return Estimate(options, views, Context(2));
  }
  PhotoConsistency Estimate(const ConsistencyOptions& options) const {
    return Estimate(options, test.views);
  }
};

// Fine texture: features of some five voxels.
inline SceneSpec SphereSpec() {
  SceneSpec spec = TestSpec("sphere", 200, 150, 16);
  spec.texture.kind = TextureKind::kSpeckle;
  spec.texture.scale = 0.18;
  spec.reference.resolution = 64;
  return spec;
}

inline SphereScene MakeSphereScene() {
  SphereScene sphere;
  sphere.test = MakeTestScene(RenderOnce(0, [](int) { return SphereSpec(); }));
  const double radius = SphereScene::kRadius / sphere.test.region.cube.edge;
  const Eigen::Vector3d middle =
      ToUnit(sphere.test.region.cube, Eigen::Vector3d::Zero());
  sphere.surface = LabelSolid(Ball(middle, radius), SphereScene::kLevel, 4);
  sphere.shell = sphere.surface.voxels;
  sphere.shell.ForEach([&](VoxelGrid::Index, MortonCode code) {
    const Eigen::Vector3f from_middle =
        VoxelCenter(DecodeMorton(code), SphereScene::kLevel) -
        middle.cast<float>();
    sphere.shapes.push_back(
        {from_middle.normalized(),
         1 / (from_middle.norm() * float(1 << SphereScene::kLevel))});
  });
  return sphere;
}

}  // namespace octacut::testing
