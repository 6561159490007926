// Surfaces that a printer cannot lay down without support.
#pragma once

#include <Eigen/Core>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct Overhangs {
  double area = 0;       // steeper than the angle, without the base
  double base_area = 0;  // that rests on the plate
  double share = 0;      // `area` as a fraction of the whole surface
};

// Measures the triangles that look down: those inclined from the vertical by
// more than `max_angle` degrees (0 to 90). Triangles whose corners are all
// within a thousandth of the height of the lowest point rest on the plate,
// which needs no support. `up` is not zero.
Overhangs MeasureOverhangs(const IndexedMesh& mesh,
                           const Eigen::Vector3d& up,
                           double max_angle);

}  // namespace octacut
