#include "core/segment/shadows.h"

#include <algorithm>
#include <cmath>

#include "core/base/hash.h"

namespace octacut {
namespace {

constexpr size_t kStep = 4;
constexpr double kLeastLight = 0.4;
constexpr double kMostLight = 0.9;
// L = 116 cbrt(Y) - 16.
constexpr float kBlack = 16;

}  // namespace

void AddShadows(std::vector<PixelFeature>* surroundings) {
  const size_t count = surroundings->size();
  for (size_t i = 0; i < count; i += kStep) {
    PixelFeature shadow = (*surroundings)[i];
    const double light =
        kLeastLight + (kMostLight - kLeastLight) * HashUniform(HashBits(i));
    const float factor = float(std::cbrt(light));
    shadow[0] = std::max(0.0f, (shadow[0] + kBlack) * factor - kBlack);
    shadow[1] *= factor;
    shadow[2] *= factor;
    surroundings->push_back(shadow);
  }
}

}  // namespace octacut
