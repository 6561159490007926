#include "core/print/overhangs.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <numbers>

#include "core/mesh/triangle_normal.h"

namespace octacut {
namespace {

// The share of the height that counts as the base: less than a layer of a print
// of hundreds of layers.
constexpr double kBaseThickness = 1e-3;

}  // namespace

Overhangs MeasureOverhangs(const IndexedMesh& mesh,
                           const Eigen::Vector3d& up,
                           double max_angle) {
  const Eigen::Vector3d axis = up.stableNormalized();
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t corner : triangle) {
      const double height = axis.dot(mesh.positions[corner]);
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
  }
  const double base_top = lowest + kBaseThickness * (highest - lowest);
  const double limit = std::sin(max_angle * std::numbers::pi / 180);
  Overhangs result;
  double total = 0;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d& p = mesh.positions[triangle[0]];
    const Eigen::Vector3d twice_area = AreaNormal(mesh, triangle);
    const double area = twice_area.norm() / 2;
    total += area;
    // The sine of the inclination from the vertical, downwards.
    if (!(-axis.dot(twice_area) > 2 * area * limit)) {
      continue;
    }
    const bool is_base = axis.dot(p) <= base_top &&
                         axis.dot(mesh.positions[triangle[1]]) <= base_top &&
                         axis.dot(mesh.positions[triangle[2]]) <= base_top;
    (is_base ? result.base_area : result.area) += area;
  }
  result.share = total > 0 ? result.area / total : 0;
  return result;
}

}  // namespace octacut
