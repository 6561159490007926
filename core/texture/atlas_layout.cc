#include "core/texture/atlas_layout.h"

#include <opencv2/core.hpp>

#include "core/base/parallel.h"
#include "core/texture/triangle_raster.h"

namespace octacut {
namespace {

// Texels beyond the triangles that are computed like those within: bilinear
// filtering looks at one, and a second one serves what comes after it.
constexpr double kExtension = 2;

// Within the chart's own box, then on the page.
void MapChart(const AtlasLayout& layout, uint32_t number, cv::Mat* map) {
  const Chart& chart = layout.charts.charts[number];
  cv::Mat own(chart.height, chart.width, CV_32SC1, cv::Scalar(0));
  cv::Mat distances(
      chart.height, chart.width, CV_32F, cv::Scalar(kExtension * kExtension));
  const auto texels_of = [&](uint32_t f) {
    std::array<Eigen::Vector2d, 3> texels;
    for (size_t k = 0; k < 3; ++k) {
      texels[k] = layout.charts.texels[f][k].cast<double>();
    }
    return texels;
  };
  for (const uint32_t f : chart.faces) {
    ForPixelsInside(texels_of(f), chart.width, chart.height, [&](int x, int y) {
      own.at<int>(y, x) = int(f) + 1;
    });
  }
  for (const uint32_t f : chart.faces) {
    const auto texels = texels_of(f);
    const Eigen::Vector2d low =
        texels[0].cwiseMin(texels[1]).cwiseMin(texels[2]).array() - kExtension;
    const Eigen::Vector2d high =
        texels[0].cwiseMax(texels[1]).cwiseMax(texels[2]).array() + kExtension;
    const int x1 = std::min(chart.width - 1, int(high.x()));
    const int y1 = std::min(chart.height - 1, int(high.y()));
    for (int y = std::max(0, int(low.y())); y <= y1; ++y) {
      for (int x = std::max(0, int(low.x())); x <= x1; ++x) {
        int& texel = own.at<int>(y, x);
        if (texel > 0) {
          continue;
        }
        const auto distance = float(
            SquaredDistanceToEdges(texels, Eigen::Vector2d(x + 0.5, y + 0.5)));
        if (distance < distances.at<float>(y, x)) {
          distances.at<float>(y, x) = distance;
          texel = -int(f) - 1;
        }
      }
    }
  }
  const ChartPlace& place = layout.packed.places[number];
  for (int y = 0; y < chart.height; ++y) {
    for (int x = 0; x < chart.width; ++x) {
      // Boxes overlap, outlines do not.
      if (own.at<int>(y, x) != 0) {
        map->at<int>(place.y + y, place.x + x) = own.at<int>(y, x);
      }
    }
  }
}

}  // namespace

cv::Mat MapTexels(const AtlasLayout& layout,
                  uint32_t page,
                  const Context& context) {
  const PageSize& size = layout.packed.pages[page];
  cv::Mat map(size.height, size.width, CV_32SC1, cv::Scalar(0));
  const size_t num_charts = layout.charts.charts.size();
  ParallelEach(context, num_charts, 16, [&](size_t chart) {
    if (layout.packed.places[chart].page == page) {
      MapChart(layout, uint32_t(chart), &map);
    }
  });
  return map;
}

}  // namespace octacut
