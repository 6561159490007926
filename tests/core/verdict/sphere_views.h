// Views of a ball, and meshes to hold against them, for the tests of this
// folder.
#pragma once

#include <vector>

#include "core/verdict/silhouette_check.h"
#include "tests/core/mesh/test_shapes.h"
#include "tests/core/views/test_scene.h"

namespace octacut::testing {

struct SphereViews {
  static constexpr double kRadius = 0.8;  // of the object, world units
  TestScene test;
  std::vector<View> given;

  // A ball that is so much larger than the object, world coordinates.
  static IndexedMesh Ball(double factor) {
    return Sphere(40, [&](const Eigen::Vector3d& direction) -> Eigen::Vector3d {
      return factor * kRadius * direction;
    });
  }
  // The object, flattened to a plane on the left side of a view.
  IndexedMesh BallBeside(size_t view) const {
    const Eigen::Vector3d right =
        given[view].cam_from_world.rotation.row(0).transpose();
    return Sphere(40, [&](const Eigen::Vector3d& direction) -> Eigen::Vector3d {
      const double x = direction.dot(right);
      return kRadius * (direction - (x < 0 ? 0.99 * x : 0) * right);
    });
  }
  IndexedMesh ToUnitMesh(IndexedMesh mesh) const {
    for (Eigen::Vector3d& position : mesh.positions) {
      position = ToUnit(test.region.cube, position);
    }
    return mesh;
  }
  // Checks a mesh in world coordinates.
  SilhouetteCheck Check(const IndexedMesh& mesh,
                        const Context& context = Context(2)) const {
    const BorderUncertainty known = UncertaintyOfBorders(0, 0);
    return CheckSilhouettes(
        RayScene(ToUnitMesh(mesh)),
        given,
        test.scene.views,
        test.views,
        std::vector<MaskUncertainty>(given.size(), {known, known}),
        context);
  }
};

inline SphereViews MakeSphereViews() {
  SphereViews sphere{MakeTestScene("sphere"), {}};
  sphere.given = sphere.test.scene.views;
  return sphere;
}

}  // namespace octacut::testing
