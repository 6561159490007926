#include "core/refine/surface_patch.h"

#include <cmath>

namespace octacut {
namespace {

constexpr float kMaxBackgroundShare = 1.0f / 3;
// Of the samples' weights, in radii of the patch.
constexpr float kSigma = 0.7f;

}  // namespace

SurfacePatch::SurfacePatch(const ViewSet& views, int radius, float pixel_noise)
    : views_(views),
      radius_(radius),
      num_samples_((2 * radius + 1) * (2 * radius + 1)),
      noise_(3 * pixel_noise * pixel_noise) {
  const float scale = 1 / (kSigma * float(radius));
  float sum = 0;
  int sample = 0;
  for (int j = -radius; j <= radius; ++j) {
    for (int i = -radius; i <= radius; ++i) {
      weights_[sample] = std::exp(-0.5f * float(i * i + j * j) * scale * scale);
      sum += weights_[sample++];
    }
  }
  for (sample = 0; sample < num_samples_; ++sample) {
    weights_[sample] /= sum;
    root_weights_[sample] = std::sqrt(weights_[sample]);
  }
}

void SurfacePatch::Place(const LocalSurface& surface,
                         const ChosenViews& chosen,
                         float spacing) {
  const Eigen::Vector3f tangent_v = surface.TangentV();
  num_views_ = 0;
  for (int n = 0; n < chosen.count; ++n) {
    const PreparedView& view = views_[chosen.views[n]];
    const ViewProjection& projection = view.projection;
    Projected& projected = projected_[num_views_];
    const Eigen::Vector3f origin = projection.Homogeneous(surface.center);
    projected.step = projection.linear * surface.normal;
    const Eigen::Vector3f step_u = projection.linear * surface.tangent_u;
    const Eigen::Vector3f step_v = projection.linear * tangent_v;
    int sample = 0;
    for (int j = -radius_; j <= radius_; ++j) {
      for (int i = -radius_; i <= radius_; ++i) {
        const float x = float(i) * spacing;
        const float y = float(j) * spacing;
        const Eigen::Vector3f h = origin + x * step_u + y * step_v +
                                  surface.Height(x, y) * projected.step;
        projected.x[sample] = h.x();
        projected.y[sample] = h.y();
        projected.z[sample++] = h.z();
      }
    }
    projected.level = &view.pyramid.LevelForFootprint(
        projection.Footprint(spacing, origin.z()));
    if (!IsBackground(projected)) {
      projected.weight = chosen.weights[n];
      ++num_views_;
    }
  }
}

bool SurfacePatch::IsBackground(const Projected& projected) const {
  int num_background = 0;
  for (int s = 0; s < num_samples_; ++s) {
    const float inverse_depth = 1 / projected.z[s];
    const Float4 color = projected.level->Sample(
        projected.x[s] * inverse_depth, projected.y[s] * inverse_depth);
    num_background += color[3] < kObjectCoverage ? 1 : 0;
  }
  return float(num_background) > kMaxBackgroundShare * float(num_samples_);
}

// Colours less their mean, times the roots of the weights.
float SurfacePatch::SampleView(const Projected& projected, float offset) {
  const Eigen::Vector3f shift = offset * projected.step;
  std::array<float, kMaxSamples> u, v;
  for (int s = 0; s < num_samples_; ++s) {
    const float inverse_depth = 1 / (projected.z[s] + shift.z());
    u[s] = (projected.x[s] + shift.x()) * inverse_depth;
    v[s] = (projected.y[s] + shift.y()) * inverse_depth;
  }
  Float4 mean = {0, 0, 0, 0};
  for (int s = 0; s < num_samples_; ++s) {
    colors_[s] = projected.level->Sample(u[s], v[s]);
    mean += colors_[s] * weights_[s];
  }
  Float4 squares = {0, 0, 0, 0};
  for (int s = 0; s < num_samples_; ++s) {
    colors_[s] = (colors_[s] - mean) * root_weights_[s];
    squares += colors_[s] * colors_[s];
  }
  return SumChannels(squares);
}

// The sum over pairs is the square of the sum less that of the squares; pixel
// noise, which differs from view to view, leaves it alone.
float SurfacePatch::Score(float offset) {
  std::array<Float4, kMaxSamples> sums = {};
  float squares = 0;
  float weights = 0;
  float squared_weights = 0;
  for (int n = 0; n < num_views_; ++n) {
    const float weight = projected_[n].weight;
    const float square = SampleView(projected_[n], offset);
    const float gain = weight / std::sqrt(square + noise_);
    squares += gain * gain * square;
    weights += weight;
    squared_weights += weight * weight;
    for (int s = 0; s < num_samples_; ++s) {
      sums[s] += gain * colors_[s];
    }
  }
  Float4 square = {0, 0, 0, 0};
  for (int s = 0; s < num_samples_; ++s) {
    square += sums[s] * sums[s];
  }
  return num_views_ < 2 ? 0
                        : (SumChannels(square) - squares) /
                              (weights * weights - squared_weights);
}

}  // namespace octacut
