// A distribution of pixel features as a mixture of normal distributions.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/segment/pixel_features.h"

namespace octacut {

class ColourMixture {
 public:
  // Says the same of every feature.
  ColourMixture() = default;

  // Fits at most `max_components` components to the samples: k-means, then
  // expectation maximization. The same samples in the same order give the same
  // mixture. No samples give the mixture that says the same of every feature.
  ColourMixture(std::span<const PixelFeature> samples, int max_components);

  // Probability density at a feature. A hundredth of it is spread evenly over
  // all features, so that one that was never seen decides nothing.
  float Density(const PixelFeature& feature) const;

 private:
  struct Component {
    Eigen::Vector4f mean = Eigen::Vector4f::Zero();
    Eigen::Matrix4f whitening = Eigen::Matrix4f::Zero();  // lower triangular
    float factor = 0;  // weight over the normal distribution's norm

    // The component's share of the density.
    float operator()(const PixelFeature& feature) const;
  };

  static Component MakeComponent(const Eigen::Vector4d& mean,
                                 const Eigen::Matrix4d& covariance,
                                 double weight);
  void Maximize(std::span<const PixelFeature> samples,
                const std::vector<float>& responsibilities,
                size_t num_components);

  std::vector<Component> components_;
};

}  // namespace octacut
