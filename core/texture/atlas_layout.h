// Which triangle each texel of a page shows.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "core/base/context.h"
#include "core/texture/charts.h"
#include "core/texture/pack_charts.h"

namespace octacut {

struct AtlasLayout {
  Charts charts;
  PackedCharts packed;

  // Texels of a triangle's corners on its page.
  std::array<Eigen::Vector2d, 3> TexelsOf(size_t face) const {
    const ChartPlace& place = packed.places[charts.chart_of_face[face]];
    std::array<Eigen::Vector2d, 3> texels;
    for (size_t k = 0; k < 3; ++k) {
      texels[k] = charts.texels[face][k].cast<double>() +
                  Eigen::Vector2d(place.x, place.y);
    }
    return texels;
  }
};

// Texels of one page. CV_32SC1: the number of a triangle plus one, where a
// texel's centre is in a triangle or within two texels of one of its chart,
// whose plane goes on there; 0 elsewhere. Texels of the second kind have their
// number negated.
cv::Mat MapTexels(const AtlasLayout& layout,
                  uint32_t page,
                  const Context& context);

// Calls body(x, y) for the texels of `map` that show a triangle, the margin
// included.
template <typename Body>
void ForTexelsOf(const cv::Mat& map,
                 size_t face,
                 const std::array<Eigen::Vector2d, 3>& texels,
                 const Body& body) {
  constexpr double kReach = 2.5;
  const Eigen::Vector2d low =
      texels[0].cwiseMin(texels[1]).cwiseMin(texels[2]).array() - kReach;
  const Eigen::Vector2d high =
      texels[0].cwiseMax(texels[1]).cwiseMax(texels[2]).array() + kReach;
  const int x0 = std::max(0, int(low.x()));
  const int y0 = std::max(0, int(low.y()));
  const int x1 = std::min(map.cols - 1, int(high.x()));
  const int y1 = std::min(map.rows - 1, int(high.y()));
  const int number = int(face) + 1;
  for (int y = y0; y <= y1; ++y) {
    const int* const row = map.ptr<int>(y);
    for (int x = x0; x <= x1; ++x) {
      if (row[x] == number || row[x] == -number) {
        body(x, y);
      }
    }
  }
}

}  // namespace octacut
