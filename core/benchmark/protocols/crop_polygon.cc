#include "core/benchmark/protocols/crop_polygon.h"

namespace octacut {

bool CropPolygon::Contains(const Eigen::Vector3d& point) const {
  if (!(point[axis] >= axis_min && point[axis] <= axis_max)) {
    return false;
  }
  const int u = axis == 0 ? 1 : 0;
  const int v = axis == 2 ? 1 : 2;
  bool inside = false;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d& a = polygon[i];
    const Eigen::Vector3d& b = polygon[(i + 1) % polygon.size()];
    if ((a[v] < point[v]) != (b[v] < point[v])) {
      const double crossing =
          a[u] + (point[v] - a[v]) / (b[v] - a[v]) * (b[u] - a[u]);
      inside ^= crossing < point[u];
    }
  }
  return inside;
}

}  // namespace octacut
