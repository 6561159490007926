// Does a surface scatter light evenly, or does it shine?
#pragma once

#include <vector>

namespace octacut {

// How far a point looks like one of a matt surface, 0 .. 1, given the
// brightness that each view shows there, grey levels; 1 for fewer than two
// views. From view to view, the brightness of a matt surface does not change,
// or, where the light moves with the camera, changes in most views and by less
// than shading can. A highlight is bright in few views and far brighter than
// the surface (docs/experiments/dents.md).
float Mattness(std::vector<float> brightness);

}  // namespace octacut
