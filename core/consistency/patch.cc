#include "core/consistency/patch.h"

#include <cmath>

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
                   const Eigen::Vector3f& center,
                   const Eigen::Vector3f& normal,
                   float spacing,
                   int radius) {
  Eigen::Vector3f tangent_u, tangent_v;
  TangentBasis(normal, &tangent_u, &tangent_v);
  num_samples_ = (2 * radius + 1) * (2 * radius + 1);
  num_views_ = 0;
  for (int i = 0; i < selection.count; ++i) {
    Colors& colors = views_[num_views_];
    colors.weight = selection.views[i].weight;
    if (SampleView(
            views[selection.views[i].view],
            {center, tangent_u * spacing, tangent_v * spacing, spacing, radius},
            &colors)) {
      ++num_views_;
    }
  }
}

bool Patch::SampleView(const PreparedView& view,
                       const Lattice& lattice,
                       Colors* colors) const {
  const int radius = lattice.radius;
  // The patch is small against its distance: its projection is affine.
  const Eigen::Vector3f h = view.projection.Homogeneous(lattice.center);
  const float inverse_depth = 1 / h.z();
  const float u = h.x() * inverse_depth;
  const float v = h.y() * inverse_depth;
  const Eigen::Vector3f step_u = view.projection.linear * lattice.step_u;
  const Eigen::Vector3f step_v = view.projection.linear * lattice.step_v;
  const float u_du = (step_u.x() - u * step_u.z()) * inverse_depth;
  const float v_du = (step_u.y() - v * step_u.z()) * inverse_depth;
  const float u_dv = (step_v.x() - u * step_v.z()) * inverse_depth;
  const float v_dv = (step_v.y() - v * step_v.z()) * inverse_depth;
  const PyramidLevel& level = view.pyramid.LevelForFootprint(
      view.projection.Footprint(lattice.spacing, h.z()));
  int num_background = 0;
  int sample = 0;
  for (int j = -radius; j <= radius; ++j) {
    for (int i = -radius; i <= radius; ++i) {
      Float4 color = level.Sample(u + float(i) * u_du + float(j) * u_dv,
                                  v + float(i) * v_du + float(j) * v_dv);
      num_background += color[3] < kObjectCoverage ? 1 : 0;
      color[3] = 0;
      colors->samples[sample++] = color;
    }
  }
  return float(num_background) <= kMaxBackgroundShare * float(sample);
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
