#include "core/segment/appearance.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/segment/shadows.h"

namespace octacut {
namespace {

// Enough to find surfaces that make up a hundredth of the pixels.
constexpr size_t kOwnSamples = 3000;
constexpr size_t kPooledSamples = 12000;
constexpr int kOwnComponents = 6;
constexpr int kPooledComponents = 12;
// Fewer pixels are no base for a model of one view.
constexpr size_t kLeastOwnSamples = 100;

}  // namespace

Appearance::Appearance(std::span<const cv::Mat> features,
                       std::span<const cv::Mat> labels,
                       bool own_objects,
                       const Context& context)
    : own_(features.size()) {
  std::vector<std::vector<PixelFeature>> objects(features.size());
  std::vector<std::vector<PixelFeature>> surroundings(features.size());
  const size_t share = std::max<size_t>(1, kPooledSamples / features.size());
  const auto thinned = [&](const std::vector<PixelFeature>& samples,
                           std::vector<PixelFeature>* pool) {
    const size_t count = std::min(share, samples.size());
    for (size_t k = 0; k < count; ++k) {
      pool->push_back(samples[k * samples.size() / count]);
    }
  };
  ParallelEach(context, features.size(), 1, [&](size_t i) {
    objects[i] =
        SampleFeatures(features[i], labels[i] == kObjectLabel, kOwnSamples);
    surroundings[i] = SampleFeatures(
        features[i], labels[i] == kSurroundingsLabel, kOwnSamples);
    const size_t num_surroundings = surroundings[i].size();
    AddShadows(&surroundings[i]);
    Models& own = own_[i];
    own.has_object = own_objects && objects[i].size() >= kLeastOwnSamples;
    own.has_surroundings = num_surroundings >= kLeastOwnSamples;
    if (own.has_object) {
      own.object = ColourMixture(objects[i], kOwnComponents);
    }
    if (own.has_surroundings) {
      own.surroundings = ColourMixture(surroundings[i], kOwnComponents);
    }
  });
  std::vector<PixelFeature> pooled_objects;
  std::vector<PixelFeature> pooled_surroundings;
  for (size_t i = 0; i < features.size(); ++i) {
    thinned(objects[i], &pooled_objects);
    thinned(surroundings[i], &pooled_surroundings);
  }
  pooled_.object = ColourMixture(pooled_objects, kPooledComponents);
  pooled_.surroundings = ColourMixture(pooled_surroundings, kPooledComponents);
}

cv::Mat Appearance::LogOdds(size_t view, const cv::Mat& features) const {
  const Models& own = own_[view];
  const auto density = [](const ColourMixture& pooled,
                          const ColourMixture& own_model,
                          bool has_own,
                          const PixelFeature& feature) {
    const float of_all = pooled.Density(feature);
    return has_own ? (of_all + own_model.Density(feature)) / 2 : of_all;
  };
  cv::Mat log_odds(features.size(), CV_32F);
  for (int y = 0; y < features.rows; ++y) {
    for (int x = 0; x < features.cols; ++x) {
      const PixelFeature& feature = features.at<PixelFeature>(y, x);
      const float object =
          density(pooled_.object, own.object, own.has_object, feature);
      const float surroundings = density(pooled_.surroundings,
                                         own.surroundings,
                                         own.has_surroundings,
                                         feature);
      log_odds.at<float>(y, x) = std::log(object / surroundings);
    }
  }
  return log_odds;
}

}  // namespace octacut
