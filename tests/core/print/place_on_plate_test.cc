#include "core/print/place_on_plate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/core/mesh/test_shapes.h"

namespace octacut {
namespace {

TEST(PlaceOnPlate, TurnsScalesAndPlaces) {
  const IndexedMesh mesh = Moved(Potato(10), {5, -3, 7});
  for (const Eigen::Vector3d& up : {Eigen::Vector3d(0, 0, 1),
                                    Eigen::Vector3d(0, 0, -2),
                                    Eigen::Vector3d(1, -2, 0.5)}) {
    const Similarity3d plate_from_mesh = PlaceOnPlate(mesh, 25, up);
    EXPECT_EQ(plate_from_mesh.scale, 25);
    const Eigen::Matrix3d& rotation = plate_from_mesh.rotation;
    EXPECT_NEAR(rotation.determinant(), 1, 1e-12);
    EXPECT_NEAR((rotation * up.normalized()).z(), 1, 1e-12);
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& position : mesh.positions) {
      box.extend(plate_from_mesh * position);
    }
    EXPECT_NEAR(box.min().z(), 0, 1e-9);
    EXPECT_NEAR(box.center().x(), 0, 1e-9);
    EXPECT_NEAR(box.center().y(), 0, 1e-9);
  }
}

TEST(PlaceOnPlate, NoTurnWhereUpIsUp) {
  const Similarity3d plate_from_mesh =
      PlaceOnPlate(Cube(2), 1, Eigen::Vector3d(0, 0, 3));
  EXPECT_EQ(plate_from_mesh.rotation, Eigen::Matrix3d::Identity());
  EXPECT_EQ(plate_from_mesh.translation, Eigen::Vector3d(-0.5, -0.5, 0));
}

}  // namespace
}  // namespace octacut
