// Rotation, translation and scale in one.
#pragma once

#include <Eigen/Core>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

// b_from_a: x_b = scale * rotation * x_a + translation.
struct Similarity3d {
  double scale = 1;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator*(const Eigen::Vector3d& x) const {
    return scale * (rotation * x) + translation;
  }
  // c_from_b * b_from_a is c_from_a.
  Similarity3d operator*(const Similarity3d& other) const {
    return {scale * other.scale,
            rotation * other.rotation,
            *this * other.translation};
  }
  Similarity3d Inverse() const {
    const Eigen::Matrix3d transposed = rotation.transpose();
    return {1 / scale, transposed, -(transposed * translation) / scale};
  }
};

// Moves the positions and turns the normals.
inline IndexedMesh TransformMesh(IndexedMesh mesh,
                                 const Similarity3d& new_from_old) {
  for (Eigen::Vector3d& position : mesh.positions) {
    position = new_from_old * position;
  }
  for (Eigen::Vector3f& normal : mesh.normals) {
    normal = new_from_old.rotation.cast<float>() * normal;
  }
  return mesh;
}

}  // namespace octacut
