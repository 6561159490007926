// Solid textures: the colour of an object as a function of space.
#pragma once

#include <cstdint>
#include <Eigen/Core>

namespace octacut {

enum class TextureKind {
  kPlain,    // one colour: nothing to match
  kMarble,   // veins and fine grain
  kSpeckle,  // spots of three sizes and many colours
  kPainted,  // patches of paint with spots and grain
};

struct TextureOptions {
  TextureKind kind = TextureKind::kPainted;
  // 0: plain, 1: as strong as the kind has it.
  double contrast = 1;
  // Size of the largest features, in world units.
  double scale = 0.2;
  // Linear reflectance where the pattern leaves it alone: red, green, blue.
  Eigen::Vector3f color{0.60f, 0.54f, 0.45f};
  uint32_t seed = 1;
  // The share of the cubes of edge `plain_size` (world units) that fill space
  // in which the object has one colour: walls without anything to match.
  double plain_share = 0;
  double plain_size = 0.4;

  void Check() const;  // throws OptionError
};

// Linear reflectance at a point in world coordinates: red, green, blue, each
// in [0, 1].
Eigen::Vector3f TextureColor(const TextureOptions& options,
                             const Eigen::Vector3f& point);

}  // namespace octacut
