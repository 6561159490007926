// What surroundings look like in the object's shadow.
#pragma once

#include <vector>

#include "core/segment/pixel_features.h"

namespace octacut {

// Adds to samples of surroundings, one for every four, what they would
// look like with 0.4 to 0.9 of their light: an object's shadow moves with it,
// so that the views agree on it as they do on the object, and only its colour
// tells it apart. Light scales the cube of L + 16, a and b (CIE Lab).
void AddShadows(std::vector<PixelFeature>* surroundings);

}  // namespace octacut
