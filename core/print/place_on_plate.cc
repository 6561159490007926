#include "core/print/place_on_plate.h"

#include <cmath>
#include <Eigen/Geometry>

namespace octacut {
namespace {

// The smallest turn that takes a direction to the z-axis.
Eigen::Matrix3d TurnToZ(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d unit = direction.stableNormalized();
  const Eigen::Vector3d axis = unit.cross(Eigen::Vector3d::UnitZ());
  const double sine = axis.norm();
  return Eigen::AngleAxisd(
             std::atan2(sine, unit.z()),
             sine > 0 ? Eigen::Vector3d(axis / sine) : Eigen::Vector3d::UnitX())
      .toRotationMatrix();
}

}  // namespace

Similarity3d PlaceOnPlate(const IndexedMesh& mesh,
                          double scale,
                          const Eigen::Vector3d& up) {
  Similarity3d plate_from_mesh;
  plate_from_mesh.scale = scale;
  plate_from_mesh.rotation = TurnToZ(up);
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
