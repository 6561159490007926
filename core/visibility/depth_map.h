// Depth maps of a voxelised surface, rendered at the voxels' own scale.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "core/views/view_projection.h"

namespace octacut {

class DepthMap {
 public:
  static constexpr float kEmpty = std::numeric_limits<float>::infinity();

  DepthMap() = default;
  // One pixel of the map is 1 / `scale` pixels of the view.
  DepthMap(const ViewProjection& projection, float scale);

  // Draws a square splat of half width `radius` (map pixels) at pixel
  // coordinates (u, v) of the view.
  void Splat(float u, float v, float radius, float depth);

  // Depth at pixel coordinates of the view; kEmpty where nothing was drawn or
  // out of the frame.
  float At(float u, float v) const {
    const float x = u * scale_;
    const float y = v * scale_;
    return x >= 0 && y >= 0 && x < float(width_) && y < float(height_)
               ? depths_[size_t(y) * width_ + size_t(x)]
               : kEmpty;
  }

 private:
  float scale_ = 1;
  int width_ = 0;
  int height_ = 0;
  std::vector<float> depths_;
};

}  // namespace octacut
