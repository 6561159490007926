#include "core/visibility/depth_map.h"

#include <algorithm>
#include <cmath>

namespace octacut {

DepthMap::DepthMap(const ViewProjection& projection, float scale)
    : scale_(scale),
      width_(int(std::ceil(projection.width * scale)) + 1),
      height_(int(std::ceil(projection.height * scale)) + 1),
      depths_(size_t(width_) * height_, kEmpty) {}

void DepthMap::Splat(float u, float v, float radius, float depth) {
  const float x = u * scale_;
  const float y = v * scale_;
  // Pixels whose centre the splat covers, at least the one below its centre.
  const int x0 = std::max(0, std::min(int(x), int(std::lround(x - radius))));
  const int y0 = std::max(0, std::min(int(y), int(std::lround(y - radius))));
  const int x1 =
      std::min(width_ - 1, std::max(int(x), int(std::lround(x + radius)) - 1));
  const int y1 =
      std::min(height_ - 1, std::max(int(y), int(std::lround(y + radius)) - 1));
  for (int row = y0; row <= y1; ++row) {
    float* depths = depths_.data() + size_t(row) * width_;
    for (int column = x0; column <= x1; ++column) {
      depths[column] = std::min(depths[column], depth);
    }
  }
}

}  // namespace octacut
