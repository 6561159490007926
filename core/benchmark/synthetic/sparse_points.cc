#include "core/benchmark/synthetic/sparse_points.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <utility>

#include "core/benchmark/synthetic/noise.h"
#include "core/mesh/surface_samples.h"
#include "core/mesh/triangle_normal.h"

namespace octacut {
namespace {

// Cosine of the steepest slant under which a feature is still found.
constexpr double kMinCosine = 0.25;

struct OrientedPoint {
  Eigen::Vector3d position;
  Eigen::Vector3d normal;
  uint32_t triangle;
};

// Triangles of the object, or of the stand.
struct Part {
  size_t begin;
  size_t end;
};

// `areas` are the cumulative ones of the part.
OrientedPoint RandomPoint(const IndexedMesh& mesh,
                          const Part& part,
                          const std::vector<double>& areas,
                          uint64_t bits) {
  const double target = areas.back() * HashUniform(HashBits(bits, 1));
  const auto triangle = static_cast<uint32_t>(
      part.begin +
      std::min<size_t>(
          std::upper_bound(areas.begin(), areas.end(), target) - areas.begin(),
          areas.size() - 1));
  return {PointInTriangle(mesh,
                          triangle,
                          HashUniform(HashBits(bits, 2)),
                          HashUniform(HashBits(bits, 3))),
          AreaNormal(mesh, mesh.triangles[triangle]).normalized(),
          triangle};
}

bool IsSeen(const OrientedPoint& sample,
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

class PointSampler {
 public:
  PointSampler(const SyntheticScene& scene, const RenderSubject& subject)
      : scene_(scene), subject_(subject) {}

  void AddSurface(const Part& part, int count, uint64_t stream) {
    const std::vector<double> areas =
        CumulativeAreas(subject_.mesh, part.begin, part.end);
    for (int i = 0; i < count; ++i) {
      const uint64_t bits = HashBits(scene_.spec.seed, stream, i);
      const OrientedPoint sample =
          RandomPoint(subject_.mesh, part, areas, bits);
      SyntheticPoint point;
      point.on_object = part.begin == 0;
      point.color =
          subject_.mesh.colors[subject_.mesh.triangles[sample.triangle][0]];
      Add(sample, bits, std::move(point));
    }
  }

  // Where random pixels of the views show the wall.
  void AddRoom(int count, uint64_t stream) {
    for (int i = 0; i < count; ++i) {
      const uint64_t bits = HashBits(scene_.spec.seed, stream, i);
      const SyntheticView& view =
          scene_.views[HashBits(bits, 1) % scene_.views.size()];
      const PinholeCamera& camera = view.lens.camera;
      const Eigen::Vector2d pixel(
          camera.width * HashUniform(HashBits(bits, 2)),
          camera.height * HashUniform(HashBits(bits, 3)));
      const Rigid3d world_from_cam = view.true_cam_from_world.Inverse();
      const Eigen::Vector3d ray =
          world_from_cam.rotation * view.lens.Unproject(pixel);
      if (subject_.rays.FirstHit(world_from_cam.translation, ray)) {
        continue;
      }
      OrientedPoint sample;
      sample.position = RoomWall(subject_, world_from_cam.translation, ray);
      sample.normal = (subject_.center - sample.position).normalized();
      sample.triangle = 0;
      SyntheticPoint point;
      point.on_object = false;
      const auto color =
          view.image.at<cv::Vec3b>(int(pixel.y()), int(pixel.x()));
      point.color = {color[2], color[1], color[0]};
      Add(sample, bits, std::move(point));
    }
  }

  std::vector<SyntheticPoint> Points() && { return std::move(points_); }

 private:
  void Add(const OrientedPoint& sample, uint64_t bits, SyntheticPoint point) {
    const double noise = scene_.spec.observation_noise;
    point.position = sample.position;
    for (uint32_t k = 0; k < scene_.views.size(); ++k) {
      const SyntheticView& view = scene_.views[k];
      if (IsSeen(sample, view, subject_.rays)) {
        Eigen::Vector2d pixel =
            view.lens.Project(view.true_cam_from_world * sample.position);
        if (noise > 0) {
          pixel += noise * Eigen::Vector2d(HashNormal(HashBits(bits, k, 4)),
                                           HashNormal(HashBits(bits, k, 5)));
        }
        point.observations.push_back({k, pixel});
      }
    }
    if (point.observations.size() >= 2) {
      points_.push_back(std::move(point));
    }
  }

  const SyntheticScene& scene_;
  const RenderSubject& subject_;
  std::vector<SyntheticPoint> points_;
};

}  // namespace

std::vector<SyntheticPoint> SampleSparsePoints(const SyntheticScene& scene,
                                               const RenderSubject& subject) {
  const int count = scene.spec.num_points;
  const size_t num_triangles = subject.mesh.triangles.size();
  const size_t num_object =
      std::min(subject.num_object_triangles, num_triangles);
  PointSampler sampler(scene, subject);
  sampler.AddSurface({0, num_object}, count, 77);
  if (num_object < num_triangles) {
    sampler.AddSurface({num_object, num_triangles}, count / 2, 78);
  }
  const BackgroundOptions& background = subject.background;
  if (background.kind == BackgroundKind::kRoom && !background.fixed_to_camera) {
    sampler.AddRoom(count / 2, 79);
  }
  return std::move(sampler).Points();
}

}  // namespace octacut
