// Masks whose false background is filled: shadows and highlights that a
// threshold or a network takes for background. Each would be a tunnel through
// the object or a bite out of it.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/base/context.h"
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

// Logs how many gaps were filled, for what reason ("other views show ..."), and
// the largest one; nothing where there are none.
void ReportGaps(const RepairedScene& repaired,
                std::string_view reason,
                const Context& context);

}  // namespace octacut
