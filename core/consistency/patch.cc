#include "core/consistency/patch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace octacut {
namespace {

// Two unit vectors that span the plane across `normal`.
void TangentBasis(const Eigen::Vector3f& normal,
                  Eigen::Vector3f* tangent_u,
                  Eigen::Vector3f* tangent_v) {
  int axis;
  normal.cwiseAbs().minCoeff(&axis);
  *tangent_u = normal.cross(Eigen::Vector3f::Unit(axis)).normalized();
  *tangent_v = normal.cross(*tangent_u);
}

}  // namespace

void Patch::Sample(const ViewSet& views,
                   const Visibility::Selection& selection,
                   const PatchSurface& surface) {
  Steps steps;
  TangentBasis(surface.normal, &steps.u, &steps.v);
  steps.u *= surface.spacing;
  steps.v *= surface.spacing;
  // At the corners the patch is turned by 45 degrees at most: a smaller part of
  // the surface is turned farther, and is no paraboloid.
  const float largest_curvature =
      std::numbers::sqrt2_v<float> /
      (2 * float(std::max(surface.radius, 1)) * surface.spacing);
  const float curvature =
      std::clamp(surface.curvature, -largest_curvature, largest_curvature);
  steps.fall =
      surface.normal * (-0.5f * curvature * surface.spacing * surface.spacing);
  num_samples_ = (2 * surface.radius + 1) * (2 * surface.radius + 1);
  num_views_ = 0;
  for (int i = 0; i < selection.count; ++i) {
    Colors& colors = views_[num_views_];
    colors.weight = selection.views[i].weight;
    if (SampleView(views[selection.views[i].view], surface, steps, &colors)) {
      ++num_views_;
    }
  }
}

bool Patch::SampleView(const PreparedView& view,
                       const PatchSurface& surface,
                       const Steps& steps,
                       Colors* colors) const {
  // The patch is small against its distance: its projection is affine.
  const Eigen::Vector3f h = view.projection.Homogeneous(surface.center);
  const float inverse_depth = 1 / h.z();
  const float u = h.x() * inverse_depth;
  const float v = h.y() * inverse_depth;
  const auto pixels_of = [&](const Eigen::Vector3f& step) -> Eigen::Vector2f {
    const Eigen::Vector3f moved = view.projection.linear * step;
    return {(moved.x() - u * moved.z()) * inverse_depth,
            (moved.y() - v * moved.z()) * inverse_depth};
  };
  const Eigen::Vector2f step_u = pixels_of(steps.u);
  const Eigen::Vector2f step_v = pixels_of(steps.v);
  const Eigen::Vector2f fall = pixels_of(steps.fall);
  const PyramidLevel& level = view.pyramid.LevelForFootprint(
      view.projection.Footprint(surface.spacing, h.z()));
  const int radius = surface.radius;
  int sample = 0;
  for (int j = -radius; j <= radius; ++j) {
    for (int i = -radius; i <= radius; ++i) {
      const float falls = float(i * i + j * j);
      Float4 color = level.Sample(
          u + float(i) * step_u.x() + float(j) * step_v.x() + falls * fall.x(),
          v + float(i) * step_u.y() + float(j) * step_v.y() + falls * fall.y());
      if (color[3] < kObjectCoverage) {
        return false;
      }
      color[3] = 0;
      colors->samples[sample++] = color;
    }
  }
  return true;
}

void Patch::Normalize(float pixel_noise, float chroma_weight) {
  const float noise = 3 * float(num_samples_) * pixel_noise * pixel_noise;
  for (int i = 0; i < num_views_; ++i) {
    Colors& colors = views_[i];
    Float4 mean = {0, 0, 0, 0};
    for (int s = 0; s < num_samples_; ++s) {
      mean += colors.samples[s];
    }
    mean /= float(num_samples_);
    Float4 squares = {0, 0, 0, 0};
    for (int s = 0; s < num_samples_; ++s) {
      colors.samples[s] = WeightChroma(colors.samples[s] - mean, chroma_weight);
      squares += colors.samples[s] * colors.samples[s];
    }
    const float contrast = SumChannels(squares);
    colors.reliability = contrast / (contrast + noise);
    const float inverse_norm = 1 / std::sqrt(contrast + noise);
    for (int s = 0; s < num_samples_; ++s) {
      colors.samples[s] *= inverse_norm;
    }
  }
}

}  // namespace octacut
