#include "core/segment/colour_mixture.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <limits>
#include <numbers>

#include "core/base/hash.h"

namespace octacut {
namespace {

constexpr int kMeansIterations = 8;
constexpr int kMixtureIterations = 4;
// A difference of one in Lab is just noticeable; smaller ones mean nothing.
constexpr double kLeastVariance = 1;
// One over the volume of the features that occur: 100 x 100 x 100 x 35.
constexpr float kEvenDensity = 1 / 3.5e7f;
constexpr float kEvenShare = 0.01f;

// Squared distance, in standard deviations, from which on a component is less
// than the even share (exp(-20) of its peak).
constexpr float kFarSquares = 40;

using Means = std::vector<Eigen::Vector4f>;

Eigen::Map<const Eigen::Vector4f> AsVector(const PixelFeature& feature) {
  return Eigen::Map<const Eigen::Vector4f>(feature.val);
}

// k-means++ with hashes for random numbers.
Means SpreadMeans(std::span<const PixelFeature> samples, int count) {
  Means means = {AsVector(samples[samples.size() / 2])};
  std::vector<float> distances(samples.size(),
                               std::numeric_limits<float>::max());
  while (int(means.size()) < count) {
    double sum = 0;
    for (size_t i = 0; i < samples.size(); ++i) {
      distances[i] = std::min(
          distances[i], (AsVector(samples[i]) - means.back()).squaredNorm());
      sum += distances[i];
    }
    double left = HashUniform(HashBits(means.size(), samples.size())) * sum;
    size_t next = 0;
    while (next + 1 < samples.size() && (left -= distances[next]) > 0) {
      ++next;
    }
    if (distances[next] <= kLeastVariance) {
      break;  // as good as all samples have a mean
    }
    means.push_back(AsVector(samples[next]));
  }
  return means;
}

size_t Nearest(const Means& means, const PixelFeature& sample) {
  size_t best = 0;
  float least = std::numeric_limits<float>::max();
  for (size_t k = 0; k < means.size(); ++k) {
    const float distance = (AsVector(sample) - means[k]).squaredNorm();
    if (distance < least) {
      least = distance;
      best = k;
    }
  }
  return best;
}

void MoveMeans(std::span<const PixelFeature> samples, Means* means) {
  std::vector<Eigen::Vector4d> sums(means->size(), Eigen::Vector4d::Zero());
  std::vector<double> counts(means->size(), 0);
  for (const PixelFeature& sample : samples) {
    const size_t k = Nearest(*means, sample);
    sums[k] += AsVector(sample).cast<double>();
    ++counts[k];
  }
  for (size_t k = 0; k < means->size(); ++k) {
    if (counts[k] > 0) {
      (*means)[k] = (sums[k] / counts[k]).cast<float>();
    }
  }
}

}  // namespace

ColourMixture::ColourMixture(std::span<const PixelFeature> samples,
                             int max_components) {
  if (samples.empty()) {
    return;
  }
  Means means = SpreadMeans(samples, max_components);
  for (int i = 0; i < kMeansIterations; ++i) {
    MoveMeans(samples, &means);
  }
  const size_t num_components = means.size();
  std::vector<float> responsibilities(samples.size() * num_components, 0);
  for (size_t i = 0; i < samples.size(); ++i) {
    responsibilities[i * num_components + Nearest(means, samples[i])] = 1;
  }
  Maximize(samples, responsibilities, num_components);
  for (int iteration = 0; iteration < kMixtureIterations; ++iteration) {
    for (size_t i = 0; i < samples.size(); ++i) {
      float* const row = &responsibilities[i * num_components];
      float sum = std::numeric_limits<float>::min();
      for (size_t k = 0; k < num_components; ++k) {
        row[k] = components_[k](samples[i]);
        sum += row[k];
      }
      for (size_t k = 0; k < num_components; ++k) {
        row[k] /= sum;
      }
    }
    Maximize(samples, responsibilities, num_components);
  }
}

float ColourMixture::Component::operator()(const PixelFeature& feature) const {
  float squares = 0;
  for (int row = 0; row < 4; ++row) {
    float value = 0;
    for (int column = 0; column <= row; ++column) {
      value += whitening(row, column) * (feature[column] - mean[column]);
    }
    squares += value * value;
    if (squares > kFarSquares) {
      return 0;  // most components are far from most features
    }
  }
  return factor * std::exp(-0.5f * squares);
}

ColourMixture::Component ColourMixture::MakeComponent(
    const Eigen::Vector4d& mean,
    const Eigen::Matrix4d& covariance,
    double weight) {
  const Eigen::Matrix4d lower =
      (covariance + kLeastVariance * Eigen::Matrix4d::Identity())
          .llt()
          .matrixL();
  Component component;
  component.mean = mean.cast<float>();
  component.whitening = lower.triangularView<Eigen::Lower>()
                            .solve(Eigen::Matrix4d::Identity())
                            .cast<float>();
  const double norm =
      4 * std::numbers::pi * std::numbers::pi * lower.diagonal().prod();
  component.factor = float(weight / norm);
  return component;
}

void ColourMixture::Maximize(std::span<const PixelFeature> samples,
                             const std::vector<float>& responsibilities,
                             size_t num_components) {
  components_.assign(num_components, Component());
  for (size_t k = 0; k < num_components; ++k) {
    double weight = 0;
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    Eigen::Matrix4d products = Eigen::Matrix4d::Zero();
    for (size_t i = 0; i < samples.size(); ++i) {
      const double r = responsibilities[i * num_components + k];
      if (r > 0) {
        const Eigen::Vector4d x = AsVector(samples[i]).cast<double>();
        weight += r;
        sum += r * x;
        products += r * x * x.transpose();
      }
    }
    if (weight > 0) {
      const Eigen::Vector4d mean = sum / weight;
      components_[k] =
          MakeComponent(mean,
                        products / weight - mean * mean.transpose(),
                        weight / double(samples.size()));
    }
  }
}

float ColourMixture::Density(const PixelFeature& feature) const {
  if (components_.empty()) {
    return kEvenDensity;
  }
  float sum = 0;
  for (const Component& component : components_) {
    sum += component(feature);
  }
  return (1 - kEvenShare) * sum + kEvenShare * kEvenDensity;
}

}  // namespace octacut
