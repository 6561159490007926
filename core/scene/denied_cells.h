// What a few silhouettes deny and all others show: a hull in cells of about two
// pixels, with the views that stand against each cell. For core/scene alone.
#pragma once

#include <array>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "core/base/context.h"
#include "core/scene/outline_distance.h"
#include "core/scene/scene.h"

namespace octacut {

// Views that deny a cell, ascending; -1: none.
using Deniers = std::array<int, 2>;

struct DeniedCells {
  double radius = 0;  // of a cell, to its corners; world units
  // Centres of the cells that no view denies, without those deep inside the
  // object in all views.
  std::vector<Eigen::Vector3d> shown;
  // The cells that one or two views deny, and those that no more than
  // max_denials deny.
  std::vector<Eigen::Vector3d> denied;
  std::vector<Deniers> deniers;
};

// Pixels around its centre's projection that a cell may take; infinite when it
// is not before the camera.
double CellRadius(const View& view,
                  const Eigen::Vector3d& center,
                  double radius);

// A view denies a cell that lies more than `slack` pixels from its object
// everywhere, so that no cell with a part of the object is denied by masks
// right to that many pixels. `max_denials` is 1 or 2. `outlines` are those of
// `views`. The same for any number of threads.
DeniedCells FindDeniedCells(const std::vector<View>& views,
                            const std::vector<OutlineDistance>& outlines,
                            const Eigen::AlignedBox3d& box,
                            size_t max_denials,
                            double slack,
                            const Context& context);

}  // namespace octacut
