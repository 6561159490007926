// What surrounds an object: the light that a shiny surface mirrors.
//
// A room far away, seen the same from everywhere on the object: ceiling, walls
// and floor, bright lamps, and things that are lighter or darker than the wall
// behind them. Its frame is z upward, y away from where one stands, x to the
// right.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/benchmark/synthetic/lighting.h"

namespace octacut {

// A rectangle on the room's sphere, upright.
struct EnvironmentPatch {
  double azimuth = 0;    // of its middle, degrees from x toward y
  double elevation = 0;  // the same, above the horizon
  double width = 20;     // degrees
  double height = 20;
  Eigen::Vector3f radiance{1, 1, 1};  // linear: red, green, blue
};

struct Environment {
  Eigen::Vector3f ceiling{0.60f, 0.62f, 0.66f};
  Eigen::Vector3f wall{0.22f, 0.20f, 0.18f};
  Eigen::Vector3f floor{0.07f, 0.045f, 0.03f};
  // Later ones cover earlier ones.
  std::vector<EnvironmentPatch> patches = {};
  // Those of the patches that light the object, too; they cover `patches`.
  std::vector<EnvironmentPatch> lamps = {};
  // Degrees over which every border is blurred, as a surface of some roughness
  // mirrors it; positive.
  double softness = 2;
};

// A room with a window, two soft boxes and some dark things; the lamps are
// `lamp_radiance` bright where the wall is about 0.2.
Environment MakeRoom(float lamp_radiance, double softness);

// Linear radiance from a direction, which need not be of unit length.
Eigen::Vector3f EnvironmentRadiance(const Environment& environment,
                                    const Eigen::Vector3f& direction);

// The lamps as lights on a diffuse surface, in the room's frame.
std::vector<AreaLight> LampLights(const Environment& environment);

}  // namespace octacut
