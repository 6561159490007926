// Colours of the texels of a page, collected from one photograph after another.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

namespace octacut {

// Colours that photographs have at one texel, 0 .. 255.
struct TexelSamples {
  // More than this many views do not change a median.
  static constexpr int kMaxViews = 7;
  struct Sample {
    std::array<uint8_t, 3> color;
    uint8_t weight;
  };
  std::array<Sample, kMaxViews> all;
  uint8_t count = 0;

  // Keeps those of most weight.
  void Add(const Sample& sample);

  // The middle of the distribution; between two samples linear in the weights,
  // so that the median changes gradually over the surface.
  uint8_t WeightedMedian(size_t channel) const;

  // The median of the differences from the median, as a standard deviation of
  // one sample; mean of the channels.
  float Deviation() const;
};

// x and y are texels, colours 0 .. 255, weights 0 .. 1.
class TexelColors {
 public:
  explicit TexelColors(const cv::Size& size);

  // Adds to the mean that is the texel's colour.
  void Add(int x, int y, const Eigen::Vector3f& color, float weight);

  // Adds to what other views say.
  void AddSample(int x, int y, const Eigen::Vector3f& color, float weight);

  // The median of the samples; false where there is none.
  bool Median(int x, int y, cv::Vec3b* pixel) const;

  // The mean, and of the samples those that differ from it by noise alone:
  // noise averages out, edges and highlights that views do not share stay out
  // (a bilateral filter across views). False where there is no mean.
  bool Mean(int x, int y, float noise, cv::Vec3b* pixel) const;

  // Standard deviation of a photograph's colour at a texel: the median over the
  // texels that three or more views show.
  float Noise() const;

 private:
  TexelSamples& At(int x, int y) {
    return samples_[size_t(y) * size_t(width_) + size_t(x)];
  }
  const TexelSamples& At(int x, int y) const {
    return samples_[size_t(y) * size_t(width_) + size_t(x)];
  }

  int width_;
  cv::Mat sums_;
  std::vector<TexelSamples> samples_;
};

}  // namespace octacut
