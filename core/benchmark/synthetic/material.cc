#include "core/benchmark/synthetic/material.h"

#include <utility>

namespace octacut {
namespace {

// From the room's frame (z upward, y away from the camera) to the camera's.
Eigen::Vector3d CameraFromRoom(const Eigen::Vector3d& direction) {
  return {direction.x(), -direction.z(), direction.y()};
}

// Lights given in the room's frame.
LightingOptions LightWith(std::vector<AreaLight> lights,
                          const Eigen::Vector3f& ambient,
                          const LightingOptions& given) {
  LightingOptions lighting;
  lighting.fixed_to_camera = given.fixed_to_camera;
  // What few rays leave of noise would be texture, where there is none.
  lighting.num_samples = 8 * given.num_samples;
  lighting.ambient = ambient;
  lighting.lights = std::move(lights);
  if (lighting.fixed_to_camera) {
    for (AreaLight& light : lighting.lights) {
      light.direction = CameraFromRoom(light.direction);
    }
  }
  return lighting;
}

// `contrast` is of veins that would be black: 0.01 are about one grey level.
TextureOptions NearlyPlain(const Eigen::Vector3f& color, double contrast) {
  TextureOptions texture;
  texture.kind = TextureKind::kMarble;
  texture.color = color;
  texture.contrast = contrast;
  texture.scale = 0.1;
  return texture;
}

Material MakeMetal(const LightingOptions& given) {
  Material metal;
  metal.texture = NearlyPlain({0.56f, 0.36f, 0.18f}, 0);
  metal.lighting = LightWith({}, Eigen::Vector3f::Zero(), given);
  metal.lighting.num_samples = given.num_samples;  // lit by nothing
  metal.finish.reflectance = {0.86f, 0.63f, 0.36f};
  metal.finish.is_metal = true;
  // As one exposes for metal: the lamps just burn out.
  metal.finish.environment = MakeRoom(2.2f, 5);
  return metal;
}

Material MakePorcelain(const LightingOptions& given) {
  Material porcelain;
  porcelain.texture = NearlyPlain({0.68f, 0.67f, 0.63f}, 0.015);
  porcelain.finish.reflectance = Eigen::Vector3f::Constant(0.05f);
  porcelain.finish.environment = MakeRoom(17, 1.5);
  porcelain.lighting = LightWith(
      LampLights(porcelain.finish.environment), {0.30f, 0.30f, 0.31f}, given);
  return porcelain;
}

Material MakePlaster(const LightingOptions& given) {
  Material plaster;
  plaster.texture = NearlyPlain({0.78f, 0.76f, 0.72f}, 0.01);
  plaster.lighting = LightWith({{{0.55, -0.5, 0.8}, 9, {0.80f, 0.78f, 0.74f}},
                                {{-0.8, 0.3, 0.35}, 14, {0.30f, 0.32f, 0.35f}},
                                {{0.3, 0.9, -0.1}, 14, {0.22f, 0.22f, 0.22f}}},
                               {0.16f, 0.16f, 0.17f},
                               given);
  return plaster;
}

}  // namespace

Material MakeMaterial(MaterialKind kind,
                      const TextureOptions& texture,
                      const LightingOptions& lighting) {
  switch (kind) {
    case MaterialKind::kMetal:
      return MakeMetal(lighting);
    case MaterialKind::kPorcelain:
      return MakePorcelain(lighting);
    case MaterialKind::kPlaster:
      return MakePlaster(lighting);
    case MaterialKind::kDiffuse:
      break;
  }
  return {texture, lighting, {}};
}

}  // namespace octacut
