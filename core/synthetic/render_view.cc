#include "core/synthetic/render_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Geometry>
#include <optional>

#include "core/base/parallel.h"
#include "core/raycast/tone_curve.h"

namespace octacut {

RenderSubject MakeRenderSubject(const IndexedMesh& mesh,
                                const RayScene& rays,
                                const TextureOptions& texture,
                                const LightingOptions& lighting,
                                const BackgroundOptions& background,
                                const Context& context) {
  texture.Check();
  lighting.Check();
  RenderSubject subject{mesh, rays, texture, lighting, background};
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& position : mesh.positions) {
    box.extend(position);
  }
  subject.center = box.center();
  subject.radius = 0;
  for (const Eigen::Vector3d& position : mesh.positions) {
    subject.radius =
        std::max(subject.radius, (position - subject.center).norm());
  }
  subject.openness = BakeOpenness(mesh, rays, lighting.num_samples, context);
  if (!lighting.fixed_to_camera) {
    for (const AreaLight& light : lighting.lights) {
      subject.visibility.push_back(BakeVisibility(mesh,
                                                  rays,
                                                  light.direction,
                                                  light.angular_radius,
                                                  lighting.num_samples,
                                                  context));
    }
  }
  return subject;
}

namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// One view's render: the pixels are independent.
class ViewRenderer {
 public:
  ViewRenderer(const RenderSubject& subject,
               const Lens& lens,
               const Rigid3d& cam_from_world,
               const Context& context)
      : subject_(subject),
        lens_(lens),
        world_from_cam_(cam_from_world.Inverse()) {
    for (const AreaLight& light : subject.lighting.lights) {
      const Vector3d direction =
          subject.lighting.fixed_to_camera
              ? Vector3d(world_from_cam_.rotation * light.direction)
              : light.direction;
      light_directions_.push_back(direction.normalized().cast<float>());
      if (subject.lighting.fixed_to_camera) {
        view_visibility_.push_back(BakeVisibility(subject.mesh,
                                                  subject.rays,
                                                  direction,
                                                  light.angular_radius,
                                                  subject.lighting.num_samples,
                                                  context));
      }
    }
    FindObjectRectangle(cam_from_world);
  }

  void RenderRow(int y, cv::Mat& image, cv::Mat& mask) const {
    auto* pixels = image.ptr<cv::Vec3b>(y);
    uint8_t* coverage = mask.ptr<uint8_t>(y);
    for (int x = 0; x < image.cols; ++x) {
      const bool near_object =
          x >= min_x_ && x <= max_x_ && y >= min_y_ && y <= max_y_;
      float covered = 0;
      Vector3f color = Vector3f::Zero();
      if (near_object) {
        covered = ShadePixel(x, y, color);
      }
      if (covered < 1) {
        color = covered * color + (1 - covered) * Background(x, y);
      }
      pixels[x] = {tone_(color.z()), tone_(color.y()), tone_(color.x())};
      coverage[x] = static_cast<uint8_t>(std::lround(255 * covered));
    }
  }

 private:
  // Pixels outside a rectangle around the projected bounding sphere cannot
  // see the object.
  void FindObjectRectangle(const Rigid3d& cam_from_world) {
    const auto& camera = lens_.camera;
    min_x_ = min_y_ = 0;
    max_x_ = camera.width;
    max_y_ = camera.height;
    Eigen::AlignedBox3d box;
    for (const Vector3d& position : subject_.mesh.positions) {
      box.extend(position);
    }
    Eigen::AlignedBox2d rectangle;
    for (int k = 0; k < 8; ++k) {
      const Vector3d corner =
          cam_from_world *
          box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k));
      if (corner.z() <= 0) {
        return;
      }
      rectangle.extend(lens_.Project(corner));
    }
    // Distortion bends the box's edges: leave room.
    const double margin =
        2 + (lens_.k1 == 0 ? 0 : 0.1 * rectangle.sizes().maxCoeff());
    min_x_ = static_cast<int>(std::max(0.0, rectangle.min().x() - margin));
    min_y_ = static_cast<int>(std::max(0.0, rectangle.min().y() - margin));
    max_x_ = static_cast<int>(
        std::min<double>(max_x_, rectangle.max().x() + margin));
    max_y_ = static_cast<int>(
        std::min<double>(max_y_, rectangle.max().y() + margin));
  }

  Vector3d Ray(double x, double y) const {
    return world_from_cam_.rotation * lens_.Unproject({x, y});
  }

  // Mean colour of the object's part of a pixel; returns how much of the
  // pixel that is.
  float ShadePixel(int x, int y, Vector3f& color) const {
    static constexpr double kOffsets[4][2] = {
        {0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
    int num_hits = 0;
    for (const auto& offset : kOffsets) {
      const Vector3d ray = Ray(x + offset[0], y + offset[1]);
      if (const auto hit =
              subject_.rays.FirstHit(world_from_cam_.translation, ray)) {
        color += Shade(*hit, ray);
        ++num_hits;
      }
    }
    if (num_hits == 0) {
      return 0;
    }
    color /= static_cast<float>(num_hits);
    return num_hits == 4 ? 1.0f : Coverage(x, y);
  }

  // Of a pixel at the silhouette, from an 8 x 8 lattice.
  float Coverage(int x, int y) const {
    constexpr int kSide = 8;
    int num_hits = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
      const Vector3d ray =
          Ray(x + (i % kSide + 0.5) / kSide, y + (i / kSide + 0.5) / kSide);
      num_hits +=
          subject_.rays.FirstHit(world_from_cam_.translation, ray).has_value();
    }
    return static_cast<float>(num_hits) / (kSide * kSide);
  }

  Vector3f Shade(const RayScene::Hit& hit, const Vector3d& ray) const {
    const auto& corners = subject_.mesh.triangles[hit.triangle];
    const float u = hit.barycentric.x();
    const float v = hit.barycentric.y();
    const auto interpolate = [&](const auto& values) {
      return (1 - u - v) * values[corners[0]] + u * values[corners[1]] +
             v * values[corners[2]];
    };
    const Vector3f point =
        (world_from_cam_.translation + hit.distance * ray).cast<float>();
    const Vector3f normal =
        Vector3f(interpolate(subject_.mesh.normals)).normalized();
    const Vector3f to_eye = -ray.normalized().cast<float>();
    const LightingOptions& lighting = subject_.lighting;
    const auto& visibility =
        lighting.fixed_to_camera ? view_visibility_ : subject_.visibility;
    Vector3f diffuse = interpolate(subject_.openness) *
                       (0.75f + 0.25f * normal.z()) * lighting.ambient;
    Vector3f highlight = Vector3f::Zero();
    for (size_t k = 0; k < light_directions_.size(); ++k) {
      const float cosine = normal.dot(light_directions_[k]);
      if (cosine <= 0) {
        continue;
      }
      const Vector3f light =
          interpolate(visibility[k]) * lighting.lights[k].color;
      diffuse += cosine * light;
      if (lighting.specular > 0) {
        const Vector3f half = (light_directions_[k] + to_eye).normalized();
        highlight += std::pow(std::max(0.0f, normal.dot(half)),
                              static_cast<float>(lighting.shininess)) *
                     static_cast<float>(lighting.specular) * light;
      }
    }
    return TextureColor(subject_.texture, point).cwiseProduct(diffuse) +
           highlight;
  }

  Vector3f Background(int x, int y) const {
    const BackgroundOptions& background = subject_.background;
    const float t =
        static_cast<float>(y + 0.5) / static_cast<float>(lens_.camera.height);
    const Vector3f plain =
        background.top + t * (background.bottom - background.top);
    if (background.kind == BackgroundKind::kPlain) {
      return plain;
    }
    // Where the ray leaves the room's sphere.
    const Vector3d ray = Ray(x + 0.5, y + 0.5).normalized();
    const Vector3d from = world_from_cam_.translation - subject_.center;
    const double room = background.room_radius * subject_.radius;
    const double along = from.dot(ray);
    const double root = along * along - from.squaredNorm() + room * room;
    const Vector3d wall = from + (std::sqrt(std::max(root, 0.0)) - along) * ray;
    TextureOptions texture = subject_.texture;
    texture.kind = TextureKind::kPainted;
    texture.contrast = 1;
    texture.scale = background.room_texture_scale * subject_.radius;
    texture.seed += 1000;
    return 0.4f * TextureColor(texture, wall.cast<float>());
  }

  const RenderSubject& subject_;
  const Lens& lens_;
  const Rigid3d world_from_cam_;
  const ToneCurve tone_;
  std::vector<Vector3f> light_directions_;
  std::vector<std::vector<float>> view_visibility_;
  int min_x_, min_y_, max_x_, max_y_;  // inclusive
};

}  // namespace

RenderedView RenderView(const RenderSubject& subject,
                        const Lens& lens,
                        const Rigid3d& cam_from_world,
                        const Context& context) {
  const ViewRenderer renderer(subject, lens, cam_from_world, context);
  RenderedView view;
  view.image.create(lens.camera.height, lens.camera.width, CV_8UC3);
  view.mask.create(lens.camera.height, lens.camera.width, CV_8UC1);
  ParallelFor(context,
              static_cast<size_t>(lens.camera.height),
              8,
              [&](size_t begin, size_t end) {
                for (size_t y = begin; y < end; ++y) {
                  renderer.RenderRow(
                      static_cast<int>(y), view.image, view.mask);
                }
              });
  return view;
}

}  // namespace octacut
