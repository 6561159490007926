#include "core/segment/border_colours.h"

#include <algorithm>
#include <cmath>

#include "core/segment/pixel_features.h"
#include "core/segment/shadows.h"

namespace octacut {
namespace {

constexpr size_t kBorderSamples = 4000;
constexpr int kBorderComponents = 6;
// Sides of tiles, in reaches; a tile's colours are those of 3 x 3 tiles around
// it (docs/experiments/mask_colours.md).
constexpr double kTileReaches = 16;
constexpr size_t kTileSamples = 1000;
constexpr size_t kLeastTileSamples = 250;
constexpr int kTileComponents = 3;

}  // namespace

BorderColours::BorderColours(const cv::Mat& features,
                             const cv::Mat& inside,
                             const cv::Mat& outside,
                             double reach)
    : tile_side_(std::max(1, int(kTileReaches * reach))),
      num_columns_((features.cols + tile_side_ - 1) / tile_side_) {
  const auto samples_of =
      [&](const cv::Mat& distances, const cv::Rect& part, size_t limit) {
        return SampleFeatures(features(part),
                              (distances(part) > reach) &
                                  (distances(part) < kLearnReaches * reach),
                              limit);
      };
  const auto learn = [](const std::vector<PixelFeature>& inner,
                        std::vector<PixelFeature> outer,
                        int num_components) {
    AddShadows(&outer);
    return Colours{ColourMixture(inner, num_components),
                   ColourMixture(outer, num_components)};
  };
  const cv::Rect all(0, 0, features.cols, features.rows);
  whole_ = learn(samples_of(inside, all, kBorderSamples),
                 samples_of(outside, all, kBorderSamples),
                 kBorderComponents);
  for (int y = 0; y < features.rows; y += tile_side_) {
    for (int x = 0; x < features.cols; x += tile_side_) {
      const cv::Rect around =
          all &
          cv::Rect(
              x - tile_side_, y - tile_side_, 3 * tile_side_, 3 * tile_side_);
      const auto inner = samples_of(inside, around, kTileSamples);
      const auto outer = samples_of(outside, around, kTileSamples);
      tiles_.emplace_back();
      if (std::min(inner.size(), outer.size()) >= kLeastTileSamples) {
        tiles_.back() = learn(inner, outer, kTileComponents);
      }
    }
  }
}

float BorderColours::LogOdds(int y, int x, const PixelFeature& feature) const {
  float object = whole_.object.Density(feature);
  float surroundings = whole_.surroundings.Density(feature);
  const int index = y / tile_side_ * num_columns_ + x / tile_side_;
  const std::optional<Colours>& tile = tiles_[size_t(index)];
  if (tile) {
    object += tile->object.Density(feature);
    surroundings += tile->surroundings.Density(feature);
  }
  return std::log(object / surroundings);
}

}  // namespace octacut
