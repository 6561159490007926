#include "core/refine/surface_patch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/check_option.h"
#include "core/refine/mattness.h"

namespace octacut {
namespace {

// The width of the samples' weights, in radii of the patch.
constexpr float kSigma = 0.7f;
// The share of a patch's gradient that is removed; removing all of it costs two
// of three measured scenes more than it gains the third
// (docs/experiments/refinement_gloss.md).
constexpr float kGradientShare = 0.5f;
// Coverage (0 .. 255), interpolated, from which on a sample shows nothing but
// the object.
constexpr float kFullCoverage = 254.5f;
// Distances from borders are known to less than that, pixels.
constexpr float kDistanceSlack = 1;

// Over the first `count` samples and all colours.
template <size_t N>
float Dot(const std::array<Float4, N>& a,
          const std::array<Float4, N>& b,
          int count) {
  Float4 sum = {0, 0, 0, 0};
  for (int s = 0; s < count; ++s) {
    sum += a[s] * b[s];
  }
  return SumChannels(sum);
}

}  // namespace

void PatchOptions::Check() const {
  CheckOption(radius >= 1 && radius <= SurfacePatch::kMaxRadius,
              "refinement.patch_radius",
              radius,
              "must be in 1 .. 4");
  CheckOption(chroma_weight >= 0 && chroma_weight <= 8,
              "refinement.chroma_weight",
              chroma_weight,
              "must be in 0 .. 8");
}

SurfacePatch::SurfacePatch(const ViewSet& views, const PatchOptions& options)
    : views_(views),
      radius_(options.radius),
      num_samples_((2 * radius_ + 1) * (2 * radius_ + 1)),
      noise_(float(3 * PatchOptions::kPixelNoise * PatchOptions::kPixelNoise)),
      chroma_weight_(float(options.chroma_weight)) {
  const float scale = 1 / (kSigma * float(radius_));
  float sum = 0;
  float squares = 0;  // of the columns
  int sample = 0;
  for (int j = -radius_; j <= radius_; ++j) {
    for (int i = -radius_; i <= radius_; ++i) {
      columns_[sample] = float(i);
      rows_[sample] = float(j);
      weights_[sample] = std::exp(-0.5f * float(i * i + j * j) * scale * scale);
      squares += weights_[sample] * float(i * i);
      sum += weights_[sample++];
    }
  }
  for (sample = 0; sample < num_samples_; ++sample) {
    const float slope = kGradientShare * weights_[sample] / squares;
    slopes_u_[sample] = slope * columns_[sample];
    slopes_v_[sample] = slope * rows_[sample];
    weights_[sample] /= sum;
    root_weights_[sample] = std::sqrt(weights_[sample]);
  }
}

void SurfacePatch::MoveTo(const LocalSurface& surface,
                          const ChosenViews& chosen,
                          float spacing) {
  const Eigen::Vector3f tangent_v = surface.TangentV();
  num_views_ = 0;
  for (int n = 0; n < chosen.count; ++n) {
    const PreparedView& view = views_[chosen.views[n]];
    const ViewProjection& projection = view.projection;
    Projected& projected = projected_[num_views_];
    projected.view = chosen.views[n];
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
    SampleColors(projected, 0, &projected.colors);
    if (ShowsOnlyObject(projected)) {
      projected.weight = chosen.weights[n];
      ++num_views_;
    }
  }
}

float SurfacePatch::SumOfWeights() const {
  float sum = 0;
  for (int n = 0; n < num_views_; ++n) {
    sum += projected_[n].weight;
  }
  return sum;
}

float SurfacePatch::Mattness() const {
  std::vector<float> brightness;
  brightness.reserve(size_t(num_views_));
  for (int n = 0; n < num_views_; ++n) {
    Float4 color = {0, 0, 0, 0};
    for (int s = 0; s < num_samples_; ++s) {
      color += weights_[s] * projected_[n].colors[s];
    }
    brightness.push_back((color[0] + color[1] + color[2]) / 3);
  }
  return octacut::Mattness(std::move(brightness));
}

void SurfacePatch::SampleColors(const Projected& projected,
                                float offset,
                                std::array<Float4, kMaxSamples>* colors) const {
  const Eigen::Vector3f shift = offset * projected.step;
  std::array<float, kMaxSamples> u, v;
  for (int s = 0; s < num_samples_; ++s) {
    const float inverse_depth = 1 / (projected.z[s] + shift.z());
    u[s] = (projected.x[s] + shift.x()) * inverse_depth;
    v[s] = (projected.y[s] + shift.y()) * inverse_depth;
  }
  for (int s = 0; s < num_samples_; ++s) {
    (*colors)[s] = projected.level->Sample(u[s], v[s]);
  }
}

bool SurfacePatch::ShowsOnlyObject(const Projected& projected) const {
  const PreparedView& view = views_[projected.view];
  for (int s = 0; s < num_samples_; ++s) {
    if (projected.colors[s][3] < kFullCoverage) {
      return false;
    }
  }
  if (!(view.border_shift > 0)) {
    return true;
  }
  // A mask that is too large counts background as object.
  const auto point_of = [&](int sample) {
    const float z = projected.z[sample];
    return ProjectedPoint{projected.x[sample] / z, projected.y[sample] / z, z};
  };
  const float pixel = 1 / projected.level->scale;
  const auto [u, v, z] = point_of(num_samples_ / 2);
  // What is closer to the middle than that is inside, too.
  const float depth =
      view.silhouette.KnowsAll(u, v, u, v)
          ? view.DistanceInside({u, v, z}) - pixel - kDistanceSlack
          : 0;
  for (int s = 0; s < num_samples_; ++s) {
    const ProjectedPoint point = point_of(s);
    if (Eigen::Vector2f(point.u - u, point.v - v).norm() > depth &&
        view.DistanceInside(point) < pixel) {
      return false;
    }
  }
  return true;
}

void SurfacePatch::Normalize(std::array<Float4, kMaxSamples>* image) const {
  Float4 mean = {0, 0, 0, 0};
  Float4 slope_u = {0, 0, 0, 0};
  Float4 slope_v = {0, 0, 0, 0};
  for (int s = 0; s < num_samples_; ++s) {
    const Float4 color = (*image)[s];
    mean += color * weights_[s];
    slope_u += color * slopes_u_[s];
    slope_v += color * slopes_v_[s];
  }
  for (int s = 0; s < num_samples_; ++s) {
    const Float4 trend = mean + slope_u * columns_[s] + slope_v * rows_[s];
    (*image)[s] =
        WeightChroma((*image)[s] - trend, chroma_weight_) * root_weights_[s];
  }
}

float SurfacePatch::SampleView(const Projected& projected, float offset) {
  if (offset == 0) {
    std::copy_n(projected.colors.begin(), num_samples_, colors_.begin());
  } else {
    SampleColors(projected, offset, &colors_);
  }
  Normalize(&colors_);
  return Dot(colors_, colors_, num_samples_);
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

void SurfacePatch::AddGradients(const Projected& projected,
                                float gain,
                                const std::array<Float4, kMaxSamples>& image,
                                float square,
                                const std::array<Float4, kMaxSamples>& residual,
                                ImageShift* shift) const {
  const float half = 0.5f / projected.level->scale;
  std::array<std::array<Float4, kMaxSamples>, 2> gradients;
  for (int s = 0; s < num_samples_; ++s) {
    const float u = projected.x[s] / projected.z[s];
    const float v = projected.y[s] / projected.z[s];
    const float factor = gain / (2 * half);
    gradients[0][s] = factor * (projected.level->Sample(u + half, v) -
                                projected.level->Sample(u - half, v));
    gradients[1][s] = factor * (projected.level->Sample(u, v + half) -
                                projected.level->Sample(u, v - half));
  }
  for (int i = 0; i < 2; ++i) {
    Normalize(&gradients[i]);
    // A brighter or darker image is not another one.
    const float along =
        Dot(gradients[i], image, num_samples_) / std::max(square, 1e-6f);
    for (int s = 0; s < num_samples_; ++s) {
      gradients[i][s] -= along * image[s];
    }
  }
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      shift->products(i, j) = Dot(gradients[i], gradients[j], num_samples_);
    }
    shift->right[i] = -Dot(gradients[i], residual, num_samples_);
  }
}

std::vector<ImageShift> SurfacePatch::FindShifts() {
  std::vector<ImageShift> shifts(static_cast<size_t>(num_views_));
  std::vector<std::array<Float4, kMaxSamples>> images(shifts.size());
  std::vector<float> gains;
  std::array<Float4, kMaxSamples> mean = {};
  float weights = 0;
  for (int n = 0; n < num_views_; ++n) {
    const float square = SampleView(projected_[n], 0);
    gains.push_back(1 / std::sqrt(square + noise_));
    weights += projected_[n].weight;
    for (int s = 0; s < num_samples_; ++s) {
      images[n][s] = gains[n] * colors_[s];
      mean[s] += projected_[n].weight * images[n][s];
    }
  }
  for (int s = 0; s < num_samples_; ++s) {
    mean[s] /= weights;
  }
  const float mean_square = Dot(mean, mean, num_samples_);
  for (int n = 0; n < num_views_; ++n) {
    ImageShift& shift = shifts[n];
    shift.view = projected_[n].view;
    const float square = Dot(images[n], images[n], num_samples_);
    shift.agreement = Dot(images[n], mean, num_samples_) /
                      std::sqrt(std::max(square * mean_square, 1e-12f));
    std::array<Float4, kMaxSamples> residual;
    for (int s = 0; s < num_samples_; ++s) {
      residual[s] = images[n][s] - mean[s];
    }
    shift.residual = Dot(residual, residual, num_samples_);
    AddGradients(projected_[n], gains[n], images[n], square, residual, &shift);
  }
  return shifts;
}

}  // namespace octacut
