#include "core/benchmark/synthetic/lighting.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <numbers>

#include "core/base/check_option.h"
#include "core/base/parallel.h"
#include "core/mesh/bounding_box.h"
#include "core/raycast/sampling.h"

namespace octacut {

void LightingOptions::Check() const {
  for (const AreaLight& light : lights) {
    CheckOption(light.direction.norm() > 0,
                "lighting.lights.direction",
                light.direction.norm(),
                "must not be zero");
    CheckOption(light.angular_radius >= 0 && light.angular_radius < 80,
                "lighting.lights.angular_radius",
                light.angular_radius,
                "must be in [0, 80)");
  }
  CheckOption(specular >= 0 && specular <= 1000,
              "lighting.specular",
              specular,
              "must be in 0 .. 1000");
  CheckOption(shininess > 0 && shininess <= 1e6,
              "lighting.shininess",
              shininess,
              "must be positive and at most 1000000");
  CheckOption(num_samples >= 1,
              "lighting.num_samples",
              num_samples,
              "must be positive");
}

namespace {

constexpr size_t kSurfaceGrain = 512;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// How far above the surface rays begin: the mesh is a polyhedron, its own
// neighbouring triangles must not count.
double RayOffset(const IndexedMesh& mesh) {
  const Eigen::AlignedBox3d box = BoundingBox(mesh);
  return 5e-4 * box.diagonal().norm();
}

// Every value half from its vertex, half from the neighbours' mean.
std::vector<float> MeanOverNeighbors(const IndexedMesh& mesh,
                                     const std::vector<float>& values) {
  std::vector<float> sums(values.size(), 0.0f);
  std::vector<float> counts(values.size(), 0.0f);
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      sums[triangle[k]] += values[triangle[(k + 1) % 3]];
      counts[triangle[k]] += 1;
    }
  }
  for (size_t i = 0; i < values.size(); ++i) {
    sums[i] = counts[i] > 0 ? (values[i] + sums[i] / counts[i]) / 2 : values[i];
  }
  return sums;
}

// Mean of `is_free(sample index)`; where the first samples agree the rest is
// spared.
template <typename IsFree>
float AdaptiveMean(int num_samples, int num_first, IsFree&& is_free) {
  int num_free = 0;
  for (int i = 0; i < num_samples; ++i) {
    if (i == num_first && (num_free == 0 || num_free == i)) {
      return num_free == 0 ? 0.0f : 1.0f;
    }
    num_free += is_free(i);
  }
  return static_cast<float>(num_free) / static_cast<float>(num_samples);
}

}  // namespace

std::vector<float> BakeVisibility(const IndexedMesh& mesh,
                                  const RayScene& rays,
                                  const Eigen::Vector3d& direction,
                                  double angular_radius,
                                  int num_samples,
                                  const Context& context) {
  std::vector<float> visibility(mesh.positions.size(), 0.0f);
  const AxisFrame frame(direction.normalized());
  const double radius = std::tan(angular_radius * std::numbers::pi / 180);
  const double offset = RayOffset(mesh);
  const int count = radius > 0 ? num_samples : 1;
  const int num_first = std::max(6, count / 4);
  const DiscPattern pattern(count);
  ParallelEach(context, mesh.positions.size(), kSurfaceGrain, [&](size_t i) {
    const Eigen::Vector3d normal = mesh.normals[i].cast<double>();
    if (normal.dot(frame.z) < -radius) {
      return;  // turned away: no part of the disc is above
    }
    const Eigen::Vector3d origin = mesh.positions[i] + offset * normal;
    const Eigen::Matrix2d turn = radius * DiscPattern::Turn(i);
    visibility[i] = AdaptiveMean(count, num_first, [&](int sample) {
      const Eigen::Vector2d disc = turn * pattern[sample];
      return !rays.IsOccluded(origin, frame.Disc(disc), 0, kInfinity);
    });
  });
  return visibility;
}

std::vector<float> BakeOpenness(const IndexedMesh& mesh,
                                const RayScene& rays,
                                int num_samples,
                                const Context& context) {
  std::vector<float> openness(mesh.positions.size());
  const double offset = RayOffset(mesh);
  const int num_first = std::max(8, num_samples / 4);
  const DiscPattern pattern(num_samples);
  ParallelEach(context, mesh.positions.size(), kSurfaceGrain, [&](size_t i) {
    const AxisFrame frame(mesh.normals[i].cast<double>().normalized());
    const Eigen::Vector3d origin = mesh.positions[i] + offset * frame.z;
    const Eigen::Matrix2d turn = DiscPattern::Turn(i);
    openness[i] = AdaptiveMean(num_samples, num_first, [&](int sample) {
      return !rays.IsOccluded(
          origin, frame.Hemisphere(turn * pattern[sample]), 0, kInfinity);
    });
  });
  // Few rays leave noise: the sky's light changes slowly over the surface.
  for (int round = 0; round < 2; ++round) {
    openness = MeanOverNeighbors(mesh, openness);
  }
  return openness;
}

}  // namespace octacut
