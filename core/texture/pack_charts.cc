#include "core/texture/pack_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/base/error.h"

namespace octacut {
namespace {

// Room between charts that their outlines leave, of the area of the charts.
constexpr double kWaste = 1.12;

// Extent of a chart in cells, column by column; empty columns have low > high.
struct Outline {
  std::vector<int> low;
  std::vector<int> high;
  int height = 0;
  size_t area = 0;

  int Width() const { return int(low.size()); }
};

Outline OutlineOf(const Charts& charts, const Chart& chart) {
  Outline outline;
  const int width = (chart.width + kPackingCell - 1) / kPackingCell;
  outline.height = (chart.height + kPackingCell - 1) / kPackingCell;
  outline.low.assign(size_t(width), outline.height);
  outline.high.assign(size_t(width), -1);
  for (const uint32_t f : chart.faces) {
    const auto& texels = charts.texels[f];
    const Eigen::Vector2f margin = Eigen::Vector2f::Constant(kChartMargin);
    const Eigen::Vector2f low =
        texels[0].cwiseMin(texels[1]).cwiseMin(texels[2]) - margin;
    const Eigen::Vector2f high =
        texels[0].cwiseMax(texels[1]).cwiseMax(texels[2]) + margin;
    const int x0 = std::max(0, int(low.x()) / kPackingCell);
    const int x1 = std::min(width - 1, int(high.x()) / kPackingCell);
    const int y0 = std::max(0, int(low.y()) / kPackingCell);
    const int y1 = std::min(outline.height - 1, int(high.y()) / kPackingCell);
    for (int x = x0; x <= x1; ++x) {
      outline.low[size_t(x)] = std::min(outline.low[size_t(x)], y0);
      outline.high[size_t(x)] = std::max(outline.high[size_t(x)], y1);
    }
  }
  for (size_t x = 0; x < outline.low.size(); ++x) {
    outline.area += size_t(std::max(0, outline.high[x] - outline.low[x] + 1));
  }
  return outline;
}

class OpenPage {
 public:
  OpenPage(int width, int max_height)
      : max_height_(max_height), bottom_(size_t(width), 0) {}

  // Places the outline as far up as it goes, or not at all.
  std::optional<std::pair<int, int>> Place(const Outline& outline) {
    const int width = int(bottom_.size());
    int best_x = -1;
    int best_y = max_height_ - outline.height + 1;
    for (int x = 0; x + outline.Width() <= width && best_y > 0; ++x) {
      int y = 0;
      for (int c = 0; c < outline.Width() && y < best_y; ++c) {
        if (outline.high[size_t(c)] >= 0) {
          y = std::max(y,
                       bottom_[size_t(x) + size_t(c)] - outline.low[size_t(c)]);
        }
      }
      if (y < best_y) {
        best_y = y;
        best_x = x;
      }
    }
    if (best_x < 0) {
      return {};
    }
    for (int c = 0; c < outline.Width(); ++c) {
      if (outline.high[size_t(c)] >= 0) {
        bottom_[size_t(best_x) + size_t(c)] =
            best_y + outline.high[size_t(c)] + 1;
      }
    }
    height_ = std::max(height_, best_y + outline.height);
    return std::make_pair(best_x, best_y);
  }

  PageSize Size() const {
    return {int(bottom_.size()) * kPackingCell,
            std::max(1, height_) * kPackingCell};
  }

 private:
  int max_height_;
  int height_ = 0;
  std::vector<int> bottom_;  // first free row of each column
};

// The charts by height, the highest first: they fit best below each other then.
std::vector<uint32_t> OrderByHeight(const std::vector<Outline>& outlines) {
  std::vector<uint32_t> order(outlines.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    const Outline& x = outlines[a];
    const Outline& y = outlines[b];
    return std::make_tuple(y.height, y.Width(), a) <
           std::make_tuple(x.height, x.Width(), b);
  });
  return order;
}

}  // namespace

PackedCharts PackCharts(const Charts& charts,
                        const PackOptions& options,
                        const Context& context) {
  Phase phase(context, "packing", charts.charts.size());
  std::vector<Outline> outlines;
  size_t area = 0;
  int widest = 1;
  int highest = 1;
  for (const Chart& chart : charts.charts) {
    outlines.push_back(OutlineOf(charts, chart));
    area += outlines.back().area;
    widest = std::max(widest, outlines.back().Width());
    highest = std::max(highest, outlines.back().height);
  }
  // MakeCharts keeps to it, but for single triangles.
  const int limit = options.max_size / kPackingCell;
  if (widest > limit || highest > limit) {
    throw OptionError(fmt::format(
        "texture_size = {}: one triangle takes {} texels; choose a larger "
        "texture_size or a smaller texel_scale",
        options.max_size,
        std::max(widest, highest) * kPackingCell));
  }
  const int side = std::clamp(
      int(std::ceil(std::sqrt(kWaste * double(area)))), widest, limit);
  PackedCharts result;
  result.places.resize(outlines.size());
  std::vector<OpenPage> pages;
  for (const uint32_t chart : OrderByHeight(outlines)) {
    for (size_t p = 0;; ++p) {
      if (p == pages.size()) {
        pages.emplace_back(side, limit);
      }
      if (const auto place = pages[p].Place(outlines[chart])) {
        result.places[chart] = {uint32_t(p),
                                place->first * kPackingCell,
                                place->second * kPackingCell};
        break;
      }
    }
    phase.Advance();
  }
  if (pages.size() > size_t(options.max_pages)) {
    throw OptionError(fmt::format(
        "max_pages = {}: the texture needs {} pages of {} x {} texels; allow "
        "more pages, a larger texture_size (at most 8192), or a smaller "
        "texel_scale",
        options.max_pages,
        pages.size(),
        options.max_size,
        options.max_size));
  }
  for (const OpenPage& page : pages) {
    result.pages.push_back(page.Size());
  }
  return result;
}

}  // namespace octacut
