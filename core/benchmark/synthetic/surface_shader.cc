#include "core/benchmark/synthetic/surface_shader.h"

#include <algorithm>
#include <cmath>

namespace octacut {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// How far above the surface mirrored rays begin, in radii of the object: the
// mesh is a polyhedron, whose neighbouring triangles must not count.
constexpr double kRayOffset = 1e-3;

// What a sample of a pixel mirrors is cut here, a little above white: a lamp in
// one of four samples must not make the whole pixel white, or outlines and
// narrow highlights get jagged.
constexpr float kBrightest = 1.5f;

// Schlick 1994; `cosine` between the view and the normal.
Vector3f Fresnel(const Vector3f& reflectance, float cosine) {
  const float beside = 1 - std::clamp(cosine, 0.0f, 1.0f);
  const float power = beside * beside * beside * beside * beside;
  return reflectance + power * (Vector3f::Ones() - reflectance);
}

}  // namespace

SurfaceShader::SurfaceShader(const RenderSubject& subject,
                             const Rigid3d& cam_from_world,
                             const Context& context)
    : subject_(subject), ray_offset_(kRayOffset * subject.radius) {
  const LightingOptions& lighting = subject.lighting;
  const Rigid3d world_from_cam = cam_from_world.Inverse();
  room_from_world_.setIdentity();
  if (lighting.fixed_to_camera) {
    Eigen::Matrix3d room_from_cam;
    room_from_cam << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    room_from_world_ = (room_from_cam * cam_from_world.rotation).cast<float>();
  }
  for (const AreaLight& light : lighting.lights) {
    const Vector3d direction =
        lighting.fixed_to_camera
            ? Vector3d(world_from_cam.rotation * light.direction)
            : light.direction;
    light_directions_.push_back(direction.normalized().cast<float>());
    if (lighting.fixed_to_camera) {
      view_visibility_.push_back(BakeVisibility(subject.mesh,
                                                subject.rays,
                                                direction,
                                                light.angular_radius,
                                                lighting.num_samples,
                                                context));
    }
  }
}

template <typename Values>
auto SurfaceShader::Interpolate(const Values& values,
                                const RayScene::Hit& hit) const {
  const auto& corners = subject_.mesh.triangles[hit.triangle];
  return hit.Mix(values[corners[0]], values[corners[1]], values[corners[2]]);
}

SurfaceShader::SurfacePoint SurfaceShader::PointAt(const RayScene::Hit& hit,
                                                   const Vector3d& origin,
                                                   const Vector3d& ray) const {
  return {hit,
          origin + hit.distance * ray,
          Interpolate(subject_.mesh.normals, hit).normalized(),
          -ray.normalized().cast<float>()};
}

Vector3f SurfaceShader::Scattered(const SurfacePoint& point) const {
  const LightingOptions& lighting = subject_.lighting;
  const Vector3f& normal = point.normal;
  const auto& visibility =
      lighting.fixed_to_camera ? view_visibility_ : subject_.visibility;
  Vector3f diffuse = Interpolate(subject_.openness, point.hit) *
                     (0.75f + 0.25f * normal.z()) * lighting.ambient;
  Vector3f highlight = Vector3f::Zero();
  for (size_t k = 0; k < light_directions_.size(); ++k) {
    const float cosine = normal.dot(light_directions_[k]);
    if (cosine <= 0) {
      continue;
    }
    const Vector3f light =
        Interpolate(visibility[k], point.hit) * lighting.lights[k].color;
    diffuse += cosine * light;
    if (lighting.specular > 0) {
      const Vector3f half = (light_directions_[k] + point.to_eye).normalized();
      highlight += std::pow(std::max(0.0f, normal.dot(half)),
                            static_cast<float>(lighting.shininess)) *
                   static_cast<float>(lighting.specular) * light;
    }
  }
  const Vector3f color = TextureColor(
      IsObject(point.hit) ? subject_.texture : subject_.stand_texture,
      point.position.cast<float>());
  return color.cwiseProduct(diffuse) + highlight;
}

Vector3f SurfaceShader::Mirrored(const SurfacePoint& point,
                                 int num_bounces) const {
  // Normals are interpolated: at the outline they may turn away from the eye.
  const float cosine = std::max(point.normal.dot(point.to_eye), 0.01f);
  const Vector3f direction =
      (2 * cosine * point.normal - point.to_eye).normalized();
  const Vector3d origin =
      point.position + ray_offset_ * point.normal.cast<double>();
  const Vector3d ray = direction.cast<double>();
  if (num_bounces > 0) {
    if (const auto hit = subject_.rays.FirstHit(origin, ray)) {
      return Sent(PointAt(*hit, origin, ray), num_bounces - 1);
    }
  }
  return EnvironmentRadiance(subject_.finish.environment,
                             room_from_world_ * direction);
}

Vector3f SurfaceShader::Sent(const SurfacePoint& point, int num_bounces) const {
  const Finish& finish = subject_.finish;
  if (!(finish.reflectance.maxCoeff() > 0) || !IsObject(point.hit)) {
    return Scattered(point);
  }
  const Vector3f fresnel =
      Fresnel(finish.reflectance, point.normal.dot(point.to_eye));
  Vector3f mirrored =
      fresnel.cwiseProduct(Mirrored(point, num_bounces)).cwiseMin(kBrightest);
  if (finish.is_metal) {
    return mirrored;
  }
  return (Vector3f::Ones() - fresnel).cwiseProduct(Scattered(point)) + mirrored;
}

Vector3f SurfaceShader::operator()(const RayScene::Hit& hit,
                                   const Vector3d& origin,
                                   const Vector3d& ray) const {
  return Sent(PointAt(hit, origin, ray), 2);
}

}  // namespace octacut
