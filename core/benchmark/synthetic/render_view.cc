#include "core/benchmark/synthetic/render_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "core/base/parallel_pixels.h"
#include "core/benchmark/synthetic/surface_shader.h"
#include "core/mesh/bounding_box.h"
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
  const Eigen::AlignedBox3d box = BoundingBox(mesh);
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

// Where in a pixel the object's colour and presence are taken: no two of them
// in one row or column.
constexpr std::array<std::array<double, 2>, 4> kOffsets = {
    {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}}};

// Where the colour is taken, too, of a surface that mirrors: its highlights may
// be narrower than a pixel.
std::vector<Eigen::Vector2d> FurtherOffsets(const Finish& finish) {
  std::vector<Eigen::Vector2d> offsets;
  if (finish.reflectance.maxCoeff() > 0) {
    for (int i = 0; i < 16; ++i) {
      offsets.emplace_back(((7 * i + 3) % 16 + 0.5) / 16, (i + 0.5) / 16);
    }
  }
  return offsets;
}

// One view's render: the pixels are independent.
class ViewRenderer {
 public:
  ViewRenderer(const RenderSubject& subject,
               const Lens& lens,
               const Rigid3d& cam_from_world,
               const Context& context)
      : subject_(subject),
        lens_(lens),
        world_from_cam_(cam_from_world.Inverse()),
        further_offsets_(FurtherOffsets(subject.finish)),
        shade_(subject, cam_from_world, context) {
    FindObjectRectangle(cam_from_world);
  }

  void RenderPixel(int x, int y, RenderedView* view) const {
    const bool near_object =
        x >= min_x_ && x <= max_x_ && y >= min_y_ && y <= max_y_;
    Covered covered;
    Vector3f color = Vector3f::Zero();
    if (near_object) {
      covered = ShadePixel(x, y, color);
    }
    if (covered.by_all < 1) {
      color = covered.by_all * color + (1 - covered.by_all) * Background(x, y);
    }
    view->image.at<cv::Vec3b>(y, x) = {
        tone_(color.z()), tone_(color.y()), tone_(color.x())};
    view->mask.at<uint8_t>(y, x) =
        static_cast<uint8_t>(std::lround(255 * covered.by_object));
  }

 private:
  struct Covered {     // parts of a pixel
    float by_all = 0;  // object and stand
    float by_object = 0;
  };
  struct Hits {  // rays
    size_t num_all = 0;
    size_t num_object = 0;
  };

  // Pixels outside a rectangle around the projected bounding sphere cannot
  // see the object.
  void FindObjectRectangle(const Rigid3d& cam_from_world) {
    const auto& camera = lens_.camera;
    min_x_ = min_y_ = 0;
    max_x_ = camera.width;
    max_y_ = camera.height;
    const Eigen::AlignedBox3d box = BoundingBox(subject_.mesh);
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

  // Mean colour of the part of a pixel that object and stand cover; returns how
  // much of the pixel that is.
  Covered ShadePixel(int x, int y, Vector3f& color) const {
    Hits hits;
    for (const auto& offset : kOffsets) {
      AddSample(x + offset[0], y + offset[1], color, hits);
    }
    if (hits.num_all == 0) {
      return {};
    }
    Hits further = hits;
    for (const Eigen::Vector2d& offset : further_offsets_) {
      AddSample(x + offset.x(), y + offset.y(), color, further);
    }
    color /= static_cast<float>(further.num_all);
    if (hits.num_all == kOffsets.size() &&
        (hits.num_object == 0 || hits.num_object == kOffsets.size())) {
      return {1, hits.num_object == 0 ? 0.0f : 1.0f};
    }
    return Coverage(x, y);
  }

  void Count(const RayScene::Hit& hit, Hits& hits) const {
    ++hits.num_all;
    hits.num_object += hit.triangle < subject_.num_object_triangles;
  }

  // Adds the colour of what is at a place of the image, if anything is.
  void AddSample(double x, double y, Vector3f& color, Hits& hits) const {
    const Vector3d ray = Ray(x, y);
    const auto hit = subject_.rays.FirstHit(world_from_cam_.translation, ray);
    if (hit) {
      color += shade_(*hit, world_from_cam_.translation, ray);
      Count(*hit, hits);
    }
  }

  // The coverage of a pixel at the silhouette, from an 8 x 8 lattice.
  Covered Coverage(int x, int y) const {
    constexpr int kSide = 8;
    Hits hits;
    for (int i = 0; i < kSide * kSide; ++i) {
      const int column = i % kSide;
      const int row = i / kSide;
      const Vector3d ray =
          Ray(x + (column + 0.5) / kSide, y + (row + 0.5) / kSide);
      if (const auto hit =
              subject_.rays.FirstHit(world_from_cam_.translation, ray)) {
        Count(*hit, hits);
      }
    }
    return {static_cast<float>(hits.num_all) / (kSide * kSide),
            static_cast<float>(hits.num_object) / (kSide * kSide)};
  }

  Vector3f Background(int x, int y) const {
    const BackgroundOptions& background = subject_.background;
    const float t =
        static_cast<float>(y + 0.5) / static_cast<float>(lens_.camera.height);
    Vector3f plain = background.top + t * (background.bottom - background.top);
    if (background.kind == BackgroundKind::kPlain) {
      return plain;
    }
    const Vector3d wall =
        background.fixed_to_camera
            ? Vector3d(background.room_radius * subject_.radius *
                       lens_.Unproject({x + 0.5, y + 0.5}).normalized())
            : Vector3d(RoomWall(subject_,
                                world_from_cam_.translation,
                                Ray(x + 0.5, y + 0.5)) -
                       subject_.center);
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
  const std::vector<Eigen::Vector2d> further_offsets_;
  const SurfaceShader shade_;
  int min_x_, min_y_, max_x_, max_y_;  // inclusive
};

}  // namespace

Vector3d RoomWall(const RenderSubject& subject,
                  const Vector3d& origin,
                  const Vector3d& ray) {
  const Vector3d direction = ray.normalized();
  const Vector3d from = origin - subject.center;
  const double room = subject.background.room_radius * subject.radius;
  const double along = from.dot(direction);
  const double root = along * along - from.squaredNorm() + room * room;
  return subject.center + from +
         (std::sqrt(std::max(root, 0.0)) - along) * direction;
}

RenderedView RenderView(const RenderSubject& subject,
                        const Lens& lens,
                        const Rigid3d& cam_from_world,
                        const Context& context) {
  const ViewRenderer renderer(subject, lens, cam_from_world, context);
  RenderedView view;
  view.image.create(lens.camera.height, lens.camera.width, CV_8UC3);
  view.mask.create(lens.camera.height, lens.camera.width, CV_8UC1);
  ParallelPixels(
      context, lens.camera.width, lens.camera.height, [&](int x, int y) {
        renderer.RenderPixel(x, y, &view);
      });
  return view;
}

}  // namespace octacut
