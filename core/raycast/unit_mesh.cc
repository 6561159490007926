#include "core/raycast/unit_mesh.h"

namespace octacut {

IndexedMesh UnitMesh(const IndexedMesh& mesh, const BoundingCube& cube) {
  IndexedMesh unit;
  unit.positions.reserve(mesh.positions.size());
  for (const Eigen::Vector3d& position : mesh.positions) {
    unit.positions.push_back(cube.ToUnit(position));
  }
  unit.triangles = mesh.triangles;
  return unit;
}

}  // namespace octacut
