#include "core/benchmark/synthetic/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/benchmark/synthetic/angles.h"

namespace octacut {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// 0 well below zero, 1 well above, with a smooth rise of width `softness`.
float SoftStep(double x, double softness) {
  const double t = std::clamp(x / softness + 0.5, 0.0, 1.0);
  return static_cast<float>(t * t * (3 - 2 * t));
}

// How much of the view toward (azimuth, elevation), in degrees, a patch covers.
float Cover(const EnvironmentPatch& patch,
            double azimuth,
            double elevation,
            double softness) {
  // Degrees of azimuth get narrower toward the zenith; a patch does not.
  const double aside = std::remainder(azimuth - patch.azimuth, 360) *
                       std::cos(Radians(patch.elevation));
  return SoftStep(patch.width / 2 - std::abs(aside), softness) *
         SoftStep(patch.height / 2 - std::abs(elevation - patch.elevation),
                  softness);
}

Vector3d PatchDirection(const EnvironmentPatch& patch) {
  const double azimuth = Radians(patch.azimuth);
  const double elevation = Radians(patch.elevation);
  return {std::cos(elevation) * std::cos(azimuth),
          std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

}  // namespace

Environment MakeRoom(float lamp_radiance, double softness) {
  Environment room;
  room.softness = softness;
  const Vector3f dark(0.012f, 0.012f, 0.014f);
  const Vector3f wood(0.14f, 0.06f, 0.025f);
  const Vector3f paper(0.55f, 0.54f, 0.50f);
  // Around the walls: door, cupboards, pictures, the one who photographs.
  room.patches = {{20, 2, 26, 44, wood},
                  {75, -4, 40, 20, dark},
                  {78, 22, 22, 18, paper},
                  {118, 8, 16, 40, {0.05f, 0.09f, 0.16f}},
                  {160, -8, 34, 22, wood},
                  {205, 14, 24, 24, {0.30f, 0.10f, 0.07f}},
                  {238, 0, 14, 60, dark},
                  {278, 0, 20, 46, {0.03f, 0.03f, 0.05f}},
                  {338, 18, 18, 14, paper},
                  // On the floor: a light carpet and the foot of a tripod.
                  {100, -52, 60, 30, {0.26f, 0.22f, 0.17f}},
                  {285, -48, 36, 24, dark}};
  const Vector3f day(0.92f, 1.0f, 1.12f);
  const Vector3f bulb(1.10f, 1.0f, 0.84f);
  // A window of two panes, a soft box from the front and above, a strip.
  room.lamps = {{311, 42, 30, 22, lamp_radiance * bulb},
                {172, 27, 13, 24, lamp_radiance * day},
                {187, 27, 11, 24, lamp_radiance * day},
                {52, 34, 7, 38, 0.7f * lamp_radiance * bulb}};
  return room;
}

Vector3f EnvironmentRadiance(const Environment& environment,
                             const Vector3f& direction) {
  const Vector3d unit = direction.cast<double>().normalized();
  const double elevation =
      std::asin(std::clamp(unit.z(), -1.0, 1.0)) * 180 / std::numbers::pi;
  const double azimuth =
      std::atan2(unit.y(), unit.x()) * 180 / std::numbers::pi;
  const double softness = environment.softness;
  // The floor begins below the horizon, the ceiling well above; both get
  // brighter toward the middle of the room.
  const auto rise = static_cast<float>(std::abs(unit.z()));
  Vector3f radiance = environment.wall;
  radiance += SoftStep(-12 - elevation, softness) *
              ((0.6f + rise) * environment.floor - radiance);
  radiance += SoftStep(elevation - 48, softness) *
              ((0.3f + 0.7f * rise) * environment.ceiling - radiance);
  for (const auto* patches : {&environment.patches, &environment.lamps}) {
    for (const EnvironmentPatch& patch : *patches) {
      radiance += Cover(patch, azimuth, elevation, softness) *
                  (patch.radiance - radiance);
    }
  }
  return radiance;
}

std::vector<AreaLight> LampLights(const Environment& environment) {
  std::vector<AreaLight> lights;
  for (const EnvironmentPatch& lamp : environment.lamps) {
    const double solid_angle = Radians(lamp.width) * Radians(lamp.height);
    // A disc of the same solid angle; a diffuse surface that faces it reflects
    // its radiance times solid angle / pi.
    AreaLight light;
    light.direction = PatchDirection(lamp);
    light.angular_radius =
        std::sqrt(solid_angle / std::numbers::pi) * 180 / std::numbers::pi;
    light.color =
        static_cast<float>(solid_angle / std::numbers::pi) * lamp.radiance;
    lights.push_back(light);
  }
  return lights;
}

}  // namespace octacut
