#include "core/hull/repaired_scene.h"

#include <algorithm>

namespace octacut {

const FalseGap& LargestGap(const RepairedScene& repaired) {
  return *std::max_element(repaired.gaps.begin(),
                           repaired.gaps.end(),
                           [](const FalseGap& a, const FalseGap& b) {
                             return a.num_pixels < b.num_pixels;
                           });
}

}  // namespace octacut
