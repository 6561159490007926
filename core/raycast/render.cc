#include "core/raycast/render.h"

#include <algorithm>
#include <Eigen/Core>
#include <limits>
#include <opencv2/core.hpp>
#include <vector>

#include "core/base/hash.h"
#include "core/base/parallel_pixels.h"
#include "core/base/srgb.h"
#include "core/mesh/bounding_box.h"
#include "core/mesh/triangle_normal.h"
#include "core/raycast/sampling.h"
#include "core/raycast/tone_curve.h"

namespace octacut {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Rays for the sky's light in hollows, of each of a pixel's four samples.
constexpr int kSkyRays = 6;

Vector3f Decode(const Vector3d& color) {
  return color.unaryExpr(&DecodeSrgb).cast<float>();
}

// Means of the triangles' normals, weighted by area.
std::vector<Vector3f> MeanNormals(const IndexedMesh& mesh) {
  std::vector<Vector3d> sums(mesh.positions.size(), Vector3d::Zero());
  for (const auto& triangle : mesh.triangles) {
    const Vector3d normal = AreaNormal(mesh, triangle);
    for (const uint32_t corner : triangle) {
      sums[corner] += normal;
    }
  }
  std::vector<Vector3f> normals(sums.size());
  for (size_t i = 0; i < sums.size(); ++i) {
    normals[i] = sums[i].normalized().cast<float>();
  }
  return normals;
}

// Rays through the pixels of a camera, from its centre, with z = 1.
struct PixelRays {
  PixelRays(const PinholeCamera& pinhole, const Rigid3d& cam_from_world)
      : camera(pinhole), world_from_cam(cam_from_world.Inverse()) {}

  const Vector3d& Origin() const { return world_from_cam.translation; }
  Vector3d Direction(double x, double y) const {
    return world_from_cam.rotation * camera.Unproject({x, y});
  }

  PinholeCamera camera;
  Rigid3d world_from_cam;
};

class ShadedRenderer {
 public:
  ShadedRenderer(const IndexedMesh& mesh,
                 const RayScene& rays,
                 const PixelRays& pixel_rays,
                 const RenderOptions& options)
      : mesh_(mesh),
        rays_(rays),
        pixel_rays_(pixel_rays),
        options_(options),
        clay_(Decode(options.clay_color)),
        pattern_(4 * kSkyRays) {
    if (mesh.normals.empty()) {
      own_normals_ = MeanNormals(mesh);
    }
    size_ = BoxOfTriangles(mesh).diagonal().norm();
    // From the upper left, and a weak one from the right.
    const Eigen::Matrix3d& turn = pixel_rays.world_from_cam.rotation;
    key_light_ = (turn * Vector3d(-0.55, -0.75, -0.75)).normalized();
    fill_light_ = (turn * Vector3d(0.9, -0.1, -0.6)).normalized();
  }

  cv::Vec3b Pixel(int x, int y) const {
    static constexpr double kOffsets[4][2] = {
        {0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
    const uint64_t bits =
        HashBits(static_cast<uint64_t>(x), static_cast<uint64_t>(y));
    Vector3f color = Vector3f::Zero();
    for (int k = 0; k < 4; ++k) {
      const Vector3d ray =
          pixel_rays_.Direction(x + kOffsets[k][0], y + kOffsets[k][1]);
      const auto hit = rays_.FirstHit(pixel_rays_.Origin(), ray);
      color += hit ? Shade(*hit, ray, k, bits) : Vector3f::Ones();
    }
    color /= 4;
    return {tone_(color.z()), tone_(color.y()), tone_(color.x())};
  }

 private:
  // Sample `part` of four: their random rays complete each other.
  Vector3f Shade(const RayScene::Hit& hit,
                 const Vector3d& ray,
                 int part,
                 uint64_t bits) const {
    const auto& corners = mesh_.triangles[hit.triangle];
    const auto& normals = own_normals_.empty() ? mesh_.normals : own_normals_;
    const Vector3f shaded = options_.normal_at ? options_.normal_at(hit)
                                               : hit.Mix(normals[corners[0]],
                                                         normals[corners[1]],
                                                         normals[corners[2]]);
    Vector3d normal = shaded.cast<double>().normalized();
    Vector3d face = AreaNormal(mesh_, corners).normalized();
    if (face.dot(ray) > 0) {  // the back of an open mesh
      face = -face;
      normal = -normal;
    }
    const Vector3d point = pixel_rays_.Origin() + hit.distance * ray;
    const Vector3d lifted = point + 1e-3 * size_ * face;

    double light = 0.05 + 0.25 * Openness(lifted, normal, part, bits);
    light += 0.18 * std::max(0.0, normal.dot(fill_light_));
    const double key = std::max(0.0, normal.dot(key_light_));
    if (key > 0 && IsLit(lifted, part, bits)) {
      light += 0.75 * key;
    }
    return static_cast<float>(light) * SurfaceColor(hit);
  }

  double Openness(const Vector3d& point,
                  const Vector3d& normal,
                  int part,
                  uint64_t bits) const {
    const AxisFrame frame(normal);
    const Eigen::Matrix2d turn = DiscPattern::Turn(bits);
    int num_free = 0;
    for (int i = 0; i < kSkyRays; ++i) {
      const Eigen::Vector2d disc = turn * pattern_[4 * i + part];
      num_free +=
          !rays_.IsOccluded(point, frame.Hemisphere(disc), 0, 0.5 * size_);
    }
    return static_cast<double>(num_free) / kSkyRays;
  }

  bool IsLit(const Vector3d& point, int part, uint64_t bits) const {
    constexpr double kLightRadius = 0.08;
    const Eigen::Vector2d disc =
        kLightRadius * (DiscPattern::Turn(HashBits(bits, 7)) * pattern_[part]);
    return !rays_.IsOccluded(
        point, AxisFrame(key_light_).Disc(disc), 0, kInfinity);
  }

  Vector3f SurfaceColor(const RayScene::Hit& hit) const {
    if (!options_.use_vertex_colors || mesh_.colors.empty()) {
      return clay_;
    }
    const auto color = [&](int k) -> Vector3f {
      const auto& bytes = mesh_.colors[mesh_.triangles[hit.triangle][k]];
      return Vector3f(bytes[0], bytes[1], bytes[2]) / 255.0f;
    };
    const Vector3f mixed = hit.Mix(color(0), color(1), color(2));
    return Decode(mixed.cast<double>());
  }

  const IndexedMesh& mesh_;
  const RayScene& rays_;
  const PixelRays& pixel_rays_;
  const RenderOptions& options_;
  const Vector3f clay_;
  const ToneCurve tone_;
  const DiscPattern pattern_;
  std::vector<Vector3f> own_normals_;
  double size_;
  Vector3d key_light_;
  Vector3d fill_light_;
};

}  // namespace

cv::Mat RenderShaded(const IndexedMesh& mesh,
                     const RayScene& rays,
                     const PinholeCamera& camera,
                     const Rigid3d& cam_from_world,
                     const RenderOptions& options,
                     const Context& context) {
  const PixelRays pixel_rays(camera, cam_from_world);
  const ShadedRenderer renderer(mesh, rays, pixel_rays, options);
  cv::Mat image(camera.height, camera.width, CV_8UC3);
  ParallelPixels(context, camera.width, camera.height, [&](int x, int y) {
    image.at<cv::Vec3b>(y, x) = renderer.Pixel(x, y);
  });
  return image;
}

cv::Mat RenderDepth(const RayScene& rays,
                    const PinholeCamera& camera,
                    const Rigid3d& cam_from_world,
                    const Context& context) {
  const PixelRays pixel_rays(camera, cam_from_world);
  cv::Mat depth(camera.height, camera.width, CV_32FC1);
  ParallelPixels(context, camera.width, camera.height, [&](int x, int y) {
    const auto hit = rays.FirstHit(pixel_rays.Origin(),
                                   pixel_rays.Direction(x + 0.5, y + 0.5));
    depth.at<float>(y, x) = hit ? static_cast<float>(hit->distance) : 0.0f;
  });
  return depth;
}

}  // namespace octacut
