#include "core/print/place_on_plate.h"

#include <Eigen/Geometry>

namespace octacut {

Similarity3d PlaceOnPlate(const IndexedMesh& mesh,
                          double scale,
                          const Eigen::Vector3d& up) {
  Similarity3d plate_from_mesh;
  plate_from_mesh.scale = scale;
  plate_from_mesh.rotation =
      Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ())
          .toRotationMatrix();
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& position : mesh.positions) {
    box.extend(plate_from_mesh * position);
  }
  const Eigen::Vector3d center = box.center();
  plate_from_mesh.translation =
      -Eigen::Vector3d(center.x(), center.y(), box.min().z());
  return plate_from_mesh;
}

}  // namespace octacut
