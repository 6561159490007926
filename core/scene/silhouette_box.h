// The box that holds the object, from the silhouettes alone.
#pragma once

#include <Eigen/Geometry>
#include <string_view>
#include <vector>

#include "core/base/context.h"
#include "core/scene/scene.h"

namespace octacut {

struct SilhouetteBox {
  // World coordinates; empty when the silhouettes leave it unbounded.
  Eigen::AlignedBox3d box;
  // Nothing is wrong with it; otherwise `doubt` says what is.
  bool sure = false;
  std::string_view doubt;
};

// The bounding box of the intersection of the silhouette pyramids, but for
// small pieces of it that hang together with nothing, found with hulls of
// (2^level)^3 cells. There is at least one view; of the views only masks and
// cameras are read. Throws InputError when no point in space is object in all
// of them.
SilhouetteBox BoxOfSilhouettes(const std::vector<View>& views,
                               int level,
                               const Context& context);

// The box of what at most `max_denials` silhouettes call background: it holds
// the object where no more masks than that are wrong. Empty when the others
// leave it unbounded, or leave nothing.
Eigen::AlignedBox3d BoxOfMostSilhouettes(const std::vector<View>& views,
                                         size_t max_denials,
                                         int level,
                                         const Context& context);

// The part of `box` that holds what all silhouettes show as object; empty when
// that is nothing. `trust_sides` as in SilhouettePyramid.
Eigen::AlignedBox3d ShrinkToHull(const std::vector<View>& views,
                                 bool trust_sides,
                                 const Eigen::AlignedBox3d& box,
                                 int level,
                                 const Context& context);

}  // namespace octacut
