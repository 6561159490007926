// Lines of sight through the pixels of the masks' objects, and which other
// views deny that there is any of the object on them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <Eigen/Geometry>
#include <vector>

#include "core/base/context.h"
#include "core/scene/scene.h"

namespace octacut {

// Views as bits: view v is bit v % 64 of word v / 64.
using ViewBits = std::vector<uint64_t>;

// The line of sight of a pixel of the object in one view. The object has to be
// somewhere on it, so at one of its points at least as many views are wrong as
// deny the point. Points that are denied by all those that deny another one
// tell nothing and are left out.
struct SightLine {
  // For each point the views that show background there, `num_words` words per
  // point. Empty if the line does not meet the box.
  std::vector<uint64_t> denials;
};

struct SightLines {
  size_t num_words = 0;
  std::vector<std::vector<SightLine>> of_views;
};

// The lines of sight of `views`, whose masks may be of low resolution, within
// `box` (world coordinates), which is to contain the object. A view in which
// the object touches the frame denies nothing beyond its frame.
SightLines TraceSightLines(const std::vector<View>& views,
                           const Eigen::AlignedBox3d& box,
                           const Context& context);

}  // namespace octacut
