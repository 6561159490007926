#include "core/texture/texel_colors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/median.h"
#include "core/texture/blend_weights.h"

namespace octacut {
namespace {

// Levels by which the photographs of a page differ at a texel, at least: those
// of rounding.
constexpr float kLeastNoise = 0.5f;
// Standard deviations of the noise by which a view's colour may differ from the
// chosen one's and still count by 60 %: the difference of two views has 1.4 of
// them by noise alone, and sampling at unlike places adds as much again.
constexpr float kSameColor = 4;

uint8_t ToByte(float value) {
  return uint8_t(std::clamp(int(std::lround(value)), 0, 255));
}

}  // namespace

void TexelSamples::Add(const Sample& sample) {
  if (count < kMaxViews) {
    all[count++] = sample;
    return;
  }
  const auto least = std::min_element(
      all.begin(), all.end(), [](const auto& a, const auto& b) {
        return a.weight < b.weight;
      });
  if (least->weight < sample.weight) {
    *least = sample;
  }
}

uint8_t TexelSamples::WeightedMedian(size_t channel) const {
  std::array<Sample, kMaxViews> sorted;
  float total = 0;
  for (size_t i = 0; i < count; ++i) {
    size_t slot = i;
    for (; slot > 0 && sorted[slot - 1].color[channel] > all[i].color[channel];
         --slot) {
      sorted[slot] = sorted[slot - 1];
    }
    sorted[slot] = all[i];
    total += float(all[i].weight);
  }
  float before = 0;
  float last_middle = 0;
  for (size_t i = 0; i < count; ++i) {
    const float middle = before + float(sorted[i].weight) / 2;
    if (middle >= total / 2) {
      if (i == 0) {
        return sorted[0].color[channel];
      }
      const float part = (total / 2 - last_middle) / (middle - last_middle);
      return ToByte((1 - part) * float(sorted[i - 1].color[channel]) +
                    part * float(sorted[i].color[channel]));
    }
    last_middle = middle;
    before += float(sorted[i].weight);
  }
  return sorted[count - 1].color[channel];
}

float TexelSamples::Deviation() const {
  float sum = 0;
  for (size_t c = 0; c < 3; ++c) {
    const float median = float(WeightedMedian(c));
    std::array<float, kMaxViews> differences{};
    for (size_t i = 0; i < count; ++i) {
      differences[i] = std::abs(float(all[i].color[c]) - median);
    }
    const auto middle = differences.begin() + count / 2;
    std::nth_element(differences.begin(), middle, differences.begin() + count);
    sum += 1.48f * *middle;
  }
  return sum / 3;
}

TexelColors::TexelColors(const cv::Size& size)
    : width_(size.width),
      sums_(size, CV_32FC4, cv::Scalar::all(0)),
      samples_(size_t(size.area())) {}

void TexelColors::Add(int x,
                      int y,
                      const Eigen::Vector3f& color,
                      float weight) {
  sums_.at<cv::Vec4f>(y, x) += cv::Vec4f(
      weight * color[0], weight * color[1], weight * color[2], weight);
}

void TexelColors::AddSample(int x,
                            int y,
                            const Eigen::Vector3f& color,
                            float weight) {
  // At least one, so that a sample counts at all.
  const int rounded = std::clamp(int(std::lround(255 * weight)), 1, 255);
  At(x, y).Add({{ToByte(color[0]), ToByte(color[1]), ToByte(color[2])},
                uint8_t(rounded)});
}

bool TexelColors::Median(int x, int y, cv::Vec3b* pixel) const {
  const TexelSamples& samples = At(x, y);
  for (int c = 0; c < 3 && samples.count > 0; ++c) {
    (*pixel)[c] = samples.WeightedMedian(size_t(c));
  }
  return samples.count > 0;
}

bool TexelColors::Mean(int x, int y, float noise, cv::Vec3b* pixel) const {
  // The chosen view counts as much as another one of the best resolution.
  const float own_weight = 255 * kFullSupport;
  const float range = kSameColor * noise;
  const cv::Vec4f& sum = sums_.at<cv::Vec4f>(y, x);
  if (!(sum[3] > 0)) {
    return false;
  }
  const Eigen::Vector3f mean = Eigen::Vector3f(sum[0], sum[1], sum[2]) / sum[3];
  Eigen::Vector3f total = own_weight * mean;
  float weights = own_weight;
  const TexelSamples& samples = At(x, y);
  for (size_t i = 0; i < samples.count; ++i) {
    const auto& bytes = samples.all[i].color;
    const Eigen::Vector3f color{
        float(bytes[0]), float(bytes[1]), float(bytes[2])};
    const float relative = (color - mean).squaredNorm() / (3 * range * range);
    const float weight = float(samples.all[i].weight) * std::exp(-relative / 2);
    total += weight * color;
    weights += weight;
  }
  for (int c = 0; c < 3; ++c) {
    (*pixel)[c] = ToByte(total[c] / weights);
  }
  return true;
}

float TexelColors::Noise() const {
  // Some hundred thousand texels do.
  const size_t step = 1 + samples_.size() / 400000;
  std::vector<float> deviations;
  for (size_t i = 0; i < samples_.size(); i += step) {
    if (samples_[i].count >= 3) {
      deviations.push_back(samples_[i].Deviation());
    }
  }
  if (deviations.empty()) {
    return kLeastNoise;
  }
  return std::max(kLeastNoise, octacut::Median(std::move(deviations)));
}

}  // namespace octacut
