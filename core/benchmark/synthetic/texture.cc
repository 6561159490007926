#include "core/benchmark/synthetic/texture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/check_option.h"
#include "core/benchmark/synthetic/noise.h"

namespace octacut {

void TextureOptions::Check() const {
  CheckOption(contrast >= 0 && contrast <= 1,
              "texture.contrast",
              contrast,
              "must be in [0, 1]");
  CheckOption(scale > 0, "texture.scale", scale, "must be positive");
  CheckOption(plain_share >= 0 && plain_share <= 1,
              "texture.plain_share",
              plain_share,
              "must be in [0, 1]");
  CheckOption(
      plain_size > 0, "texture.plain_size", plain_size, "must be positive");
  CheckOption((color.array() >= 0).all() && (color.array() <= 1).all(),
              "texture.color",
              color.maxCoeff(),
              "must be in [0, 1]");
}

namespace {

using Eigen::Vector3f;

Vector3f Mix(const Vector3f& a, const Vector3f& b, float t) {
  return a + t * (b - a);
}

float SmoothStep(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

Vector3f Palette(float choice) {
  static constexpr std::array<std::array<float, 3>, 6> kColors = {
      {{0.62f, 0.16f, 0.08f},
       {0.08f, 0.22f, 0.34f},
       {0.80f, 0.62f, 0.24f},
       {0.06f, 0.05f, 0.05f},
       {0.85f, 0.82f, 0.74f},
       {0.18f, 0.34f, 0.20f}}};
  const auto& color =
      kColors[static_cast<size_t>(choice * kColors.size()) % kColors.size()];
  return {color[0], color[1], color[2]};
}

// Spots of one size over `color`; their border is as wide as a fifth of a spot.
Vector3f PaintSpots(const Vector3f& color,
                    const Vector3f& point,
                    float strength,
                    uint32_t seed) {
  const SpotSample spot = SampleSpot(point, seed);
  const float cover = strength * SmoothStep(0, 0.2f, spot.depth);
  return cover > 0 ? Mix(color, Palette(spot.choice), cover) : color;
}

Vector3f Marble(const Vector3f& base, const Vector3f& p, uint32_t seed) {
  const float turbulence = FractalNoise(2 * p, 4, seed);
  const float wave = std::abs(
      std::sin(2 * (p.x() + 0.7f * p.y() + 0.4f * p.z()) + 6 * turbulence));
  const Vector3f vein(0.10f, 0.07f, 0.06f);
  const Vector3f color = Mix(vein, base, SmoothStep(0, 0.5f, wave));
  return color * (1 + 0.5f * FractalNoise(9 * p, 3, seed + 50));
}

Vector3f Speckle(const Vector3f& base, const Vector3f& p, uint32_t seed) {
  Vector3f color = PaintSpots(base, p, 0.7f, seed);
  color = PaintSpots(color, 2.3f * p, 0.8f, seed + 10);
  color = PaintSpots(color, 5.1f * p, 0.9f, seed + 20);
  return color * (1 + 0.3f * FractalNoise(6 * p, 2, seed + 30));
}

Vector3f Painted(const Vector3f& base, const Vector3f& p, uint32_t seed) {
  const float patch = FractalNoise(p, 3, seed);
  Vector3f color = base;
  color = Mix(color, Palette(0.2f), SmoothStep(0.12f, 0.16f, patch));
  color = Mix(color, Palette(0.4f), SmoothStep(-0.16f, -0.20f, patch));
  color = PaintSpots(color, 2.1f * p, 0.75f, seed + 10);
  color = PaintSpots(color, 5.3f * p, 0.8f, seed + 20);
  return color * (1 + 0.45f * FractalNoise(7 * p, 3, seed + 30));
}

bool IsInPlainCube(const TextureOptions& options, const Vector3f& point) {
  if (options.plain_share <= 0) {
    return false;
  }
  const Eigen::Array3d cube =
      (point.cast<double>() / options.plain_size).array().floor();
  const auto bits = [&](int axis) {
    return static_cast<uint64_t>(static_cast<int64_t>(cube[axis]));
  };
  return HashUniform(HashBits(options.seed, bits(0), bits(1), bits(2))) <
         options.plain_share;
}

}  // namespace

Vector3f TextureColor(const TextureOptions& options, const Vector3f& point) {
  if (IsInPlainCube(options, point)) {
    return options.color;
  }
  const Vector3f p = point / static_cast<float>(options.scale);
  Vector3f color = options.color;
  switch (options.kind) {
    case TextureKind::kPlain:
      return color;
    case TextureKind::kMarble:
      color = Marble(color, p, options.seed);
      break;
    case TextureKind::kSpeckle:
      color = Speckle(color, p, options.seed);
      break;
    case TextureKind::kPainted:
      color = Painted(color, p, options.seed);
      break;
  }
  return Mix(options.color, color, static_cast<float>(options.contrast))
      .cwiseMax(0.02f)
      .cwiseMin(0.95f);
}

}  // namespace octacut
