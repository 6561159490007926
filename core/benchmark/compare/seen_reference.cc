#include "core/benchmark/compare/seen_reference.h"

#include <fmt/format.h>

#include <cmath>
#include <Eigen/Core>
#include <memory>
#include <numbers>

#include "core/base/check_option.h"
#include "core/mesh/triangle_normal.h"
#include "core/raycast/ray_scene.h"

namespace octacut {
namespace {

// How far before the surface a ray may end, as a fraction of its length: the
// surface must not hide itself by rounding.
constexpr double kClearance = 1e-5;

struct SeeingCamera {
  PosedCamera posed;
  Eigen::Vector3d center;
};

struct SeenReference {
  RayScene rays;
  std::vector<Eigen::Vector3d> normals;  // of the triangles
  std::vector<SeeingCamera> cameras;
  double min_cosine;
  int min_views;

  bool Sees(const SeeingCamera& camera,
            const Eigen::Vector3d& point,
            const Eigen::Vector3d& normal) const {
    const Eigen::Vector3d to_camera = camera.center - point;
    if (to_camera.dot(normal) < min_cosine * to_camera.norm()) {
      return false;
    }
    return camera.posed.camera.ProjectIntoFrame(camera.posed.cam_from_world *
                                                point) &&
           !rays.IsOccluded(camera.center, -to_camera, 0, 1 - kClearance);
  }

  bool Counts(uint32_t triangle, const Eigen::Vector3d& point) const {
    int seeing = 0;
    for (const SeeingCamera& camera : cameras) {
      if (Sees(camera, point, normals[triangle]) && ++seeing == min_views) {
        return true;
      }
    }
    return false;
  }
};

}  // namespace

void SeenReferenceOptions::Check() const {
  CheckOption(min_views >= 1, "min_views", min_views, "must be positive");
  CheckOption(max_angle >= 1 && max_angle <= 90,
              "max_view_angle",
              max_angle,
              "must be in 1 .. 90");
}

ReferenceFilter SeenByCameras(const IndexedMesh& reference,
                              std::vector<PosedCamera> cameras,
                              const SeenReferenceOptions& options) {
  options.Check();
  if (cameras.size() < size_t(options.min_views)) {
    throw InputError(fmt::format(
        "{} cameras are too few: at least min_views = {} are needed",
        cameras.size(),
        options.min_views));
  }
  auto seen = std::make_shared<SeenReference>(
      SeenReference{RayScene(reference),
                    {},
                    {},
                    std::cos(options.max_angle * std::numbers::pi / 180),
                    options.min_views});
  seen->normals.reserve(reference.triangles.size());
  for (const auto& triangle : reference.triangles) {
    seen->normals.push_back(AreaNormal(reference, triangle).normalized());
  }
  for (PosedCamera& camera : cameras) {
    const Eigen::Vector3d center = camera.cam_from_world.Inverse().translation;
    seen->cameras.push_back({std::move(camera), center});
  }
  return [seen](uint32_t triangle, const Eigen::Vector3d& point) {
    return seen->Counts(triangle, point);
  };
}

}  // namespace octacut
