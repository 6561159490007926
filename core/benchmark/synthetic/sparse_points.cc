#include "core/benchmark/synthetic/sparse_points.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "core/benchmark/synthetic/noise.h"

namespace octacut {
namespace {

// Cosine of the steepest slant under which a feature is still found.
constexpr double kMinCosine = 0.25;

struct SurfaceSample {
  Eigen::Vector3d position;
  Eigen::Vector3d normal;
  uint32_t triangle;
};

// Cumulated areas of the triangles.
std::vector<double> CumulateAreas(const IndexedMesh& mesh) {
  std::vector<double> areas;
  double total = 0;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.positions[triangle[0]];
    total += (mesh.positions[triangle[1]] - a)
                 .cross(mesh.positions[triangle[2]] - a)
                 .norm() /
             2;
    areas.push_back(total);
  }
  return areas;
}

SurfaceSample SampleSurface(const IndexedMesh& mesh,
                            const std::vector<double>& areas,
                            uint64_t bits) {
  const double target = areas.back() * HashUniform(HashBits(bits, 1));
  const size_t triangle = std::min<size_t>(
      std::upper_bound(areas.begin(), areas.end(), target) - areas.begin(),
      areas.size() - 1);
  double u = HashUniform(HashBits(bits, 2));
  double v = HashUniform(HashBits(bits, 3));
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const auto& corners = mesh.triangles[triangle];
  const Eigen::Vector3d& a = mesh.positions[corners[0]];
  const Eigen::Vector3d ab = mesh.positions[corners[1]] - a;
  const Eigen::Vector3d ac = mesh.positions[corners[2]] - a;
  return {a + u * ab + v * ac,
          ab.cross(ac).normalized(),
          static_cast<uint32_t>(triangle)};
}

bool IsSeen(const SurfaceSample& sample,
            const SyntheticView& view,
            const RayScene& rays) {
  const Eigen::Vector3d in_cam = view.true_cam_from_world * sample.position;
  if (in_cam.z() <= 0) {
    return false;
  }
  const Eigen::Vector2d pixel = view.lens.Project(in_cam);
  const PinholeCamera& camera = view.lens.camera;
  if (!(pixel.x() >= 0 && pixel.x() < camera.width && pixel.y() >= 0 &&
        pixel.y() < camera.height)) {
    return false;
  }
  const Eigen::Vector3d center = view.true_cam_from_world.Inverse().translation;
  const Eigen::Vector3d toward = center - sample.position;
  return sample.normal.dot(toward) > kMinCosine * toward.norm() &&
         !rays.IsOccluded(sample.position, toward, 1e-4, 1);
}

}  // namespace

std::vector<SyntheticPoint> SampleSparsePoints(const SyntheticScene& scene,
                                               const RayScene& rays) {
  const SceneSpec& spec = scene.spec;
  const std::vector<double> areas = CumulateAreas(scene.reference);
  std::vector<SyntheticPoint> points;
  for (int i = 0; i < spec.num_points; ++i) {
    const uint64_t bits = HashBits(spec.seed, 77, i);
    const SurfaceSample sample = SampleSurface(scene.reference, areas, bits);
    SyntheticPoint point;
    point.position = sample.position;
    point.color =
        scene.reference.colors[scene.reference.triangles[sample.triangle][0]];
    for (uint32_t k = 0; k < scene.views.size(); ++k) {
      const SyntheticView& view = scene.views[k];
      if (IsSeen(sample, view, rays)) {
        Eigen::Vector2d pixel =
            view.lens.Project(view.true_cam_from_world * sample.position);
        if (spec.observation_noise > 0) {
          pixel += spec.observation_noise *
                   Eigen::Vector2d(HashNormal(HashBits(bits, k, 4)),
                                   HashNormal(HashBits(bits, k, 5)));
        }
        point.observations.push_back({k, pixel});
      }
    }
    if (point.observations.size() >= 2) {
      points.push_back(std::move(point));
    }
  }
  return points;
}

}  // namespace octacut
