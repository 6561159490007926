// Masks whose false background is filled: shadows and highlights that a
// threshold or a network takes for background. Each would be a tunnel through
// the object or a bite out of it.
#pragma once

#include <cstddef>
#include <vector>

#include "core/scene/scene.h"

namespace octacut {

// Background that is object, as other views or sparse points show.
struct FalseGap {
  size_t view = 0;
  size_t num_pixels = 0;
};

struct RepairedScene {
  Scene scene;  // shares images and masks that are as they were
  std::vector<FalseGap> gaps;
};

// The first one of those with most pixels; there must be one.
const FalseGap& LargestGap(const RepairedScene& repaired);

}  // namespace octacut
