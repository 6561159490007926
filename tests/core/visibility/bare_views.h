// Views without pictures around the cube, for what needs projections alone.
#pragma once

#include <cmath>
#include <vector>

#include "core/views/view_set.h"
#include "tests/core/views/random_views.h"

namespace octacut::testing {

inline std::vector<Eigen::Vector3d> DirectionsAllAround(int count) {
  std::vector<Eigen::Vector3d> directions;
  for (int i = 0; i < count; ++i) {
    const double z = 0.9 * (2 * (i + 0.5) / count - 1);
    const double azimuth = 2.399963 * i;  // the golden angle
    const double r = std::sqrt(1 - z * z);
    directions.emplace_back(r * std::cos(azimuth), r * std::sin(azimuth), z);
  }
  return directions;
}

// From `directions` at a distance of three edges; the whole cube is in sight.
inline ViewSet BareViews(const std::vector<Eigen::Vector3d>& directions) {
  BoundingCube cube;
  cube.min_corner.setZero();
  cube.edge = 1;
  ViewSet views(directions.size());
  for (size_t i = 0; i < views.size(); ++i) {
    View view;
    view.camera = {240, 240, 320, 320, 120, 120};
    view.cam_from_world =
        LookAt(cube.Center() + 3 * directions[i], cube.Center());
    views[i].projection = MakeViewProjection(view, cube);
  }
  return views;
}

}  // namespace octacut::testing
