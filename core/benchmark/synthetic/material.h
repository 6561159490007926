// What an object is made of: three kinds that are hard to reconstruct beside
// the painted, matte one.
#pragma once

#include <Eigen/Core>

#include "core/benchmark/synthetic/environment.h"
#include "core/benchmark/synthetic/lighting.h"
#include "core/benchmark/synthetic/texture.h"

namespace octacut {

enum class MaterialKind {
  kDiffuse,    // texture and lights as given
  kMetal,      // polished bronze: nothing but a mirror of its surroundings
  kPorcelain,  // white and plain, glazed: highlights that burn out
  kPlaster,    // white, plain and matte
};

// How a surface mirrors what is around it.
struct Finish {
  // Linear, of light that falls in along the normal: red, green, blue. Grows
  // toward 1 at grazing angles (Schlick 1994). Zero: it does not mirror.
  Eigen::Vector3f reflectance = Eigen::Vector3f::Zero();
  // What is not mirrored is absorbed, not scattered.
  bool is_metal = false;
  Environment environment = {};  // as MakeRoom has its frame
};

struct Material {
  TextureOptions texture;
  LightingOptions lighting;
  Finish finish;
};

// Kinds other than kDiffuse bring texture and lights of their own; of
// `lighting` they keep what the lights are fixed to, and the number of samples.
// Fixed to the camera, the surroundings turn with it like the lights.
Material MakeMaterial(MaterialKind kind,
                      const TextureOptions& texture,
                      const LightingOptions& lighting);

}  // namespace octacut
