#include "core/benchmark/synthetic/noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace octacut {
namespace {

// Cheaper than HashBits: a lattice point is hashed eight times a noise.
inline uint32_t HashLattice(int32_t x, int32_t y, int32_t z, uint32_t seed) {
  uint32_t h = static_cast<uint32_t>(x) * 0x8da6b343u ^
               static_cast<uint32_t>(y) * 0xd8163841u ^
               static_cast<uint32_t>(z) * 0xcb1ab31fu ^ seed * 0x9e3779b9u;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  return h ^ (h >> 15);
}

inline float ToSigned(uint32_t bits) {
  return static_cast<float>(bits >> 8) * 0x1p-23f - 1.0f;
}

inline float ToUnsigned(uint32_t bits) {
  return static_cast<float>(bits >> 8) * 0x1p-24f;
}

inline float Fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }

inline float Mix(float a, float b, float t) { return a + t * (b - a); }

}  // namespace

double HashNormal(uint64_t bits) {
  const double radius =
      std::sqrt(-2 * std::log(1 - HashUniform(HashBits(bits, 1))));
  const double angle = 2 * std::numbers::pi * HashUniform(HashBits(bits, 2));
  return radius * std::cos(angle);
}

namespace {

// The eight corners at once, in a form that compilers turn into vectors.
[[gnu::always_inline]] inline float NoiseAt(float x,
                                            float y,
                                            float z,
                                            uint32_t seed) {
  const float floor_x = std::floor(x);
  const float floor_y = std::floor(y);
  const float floor_z = std::floor(z);
  const auto cell_x = static_cast<int32_t>(floor_x);
  const auto cell_y = static_cast<int32_t>(floor_y);
  const auto cell_z = static_cast<int32_t>(floor_z);
  float corners[8];
  for (int k = 0; k < 8; ++k) {
    corners[k] = ToSigned(HashLattice(
        cell_x + (k & 1), cell_y + (k >> 1 & 1), cell_z + (k >> 2), seed));
  }
  const float u = Fade(x - floor_x);
  const float v = Fade(y - floor_y);
  const float w = Fade(z - floor_z);
  const float low =
      Mix(Mix(corners[0], corners[1], u), Mix(corners[2], corners[3], u), v);
  const float high =
      Mix(Mix(corners[4], corners[5], u), Mix(corners[6], corners[7], u), v);
  return Mix(low, high, w);
}

}  // namespace

float FractalNoise(const Eigen::Vector3f& point, int octaves, uint32_t seed) {
  float sum = 0;
  float strength = 1;
  float total = 0;
  float x = point.x();
  float y = point.y();
  float z = point.z();
  for (int octave = 0; octave < octaves; ++octave) {
    sum += strength * NoiseAt(x, y, z, seed + static_cast<uint32_t>(octave));
    total += strength;
    strength *= 0.5f;
    // Not exactly 2 and shifted: the lattices' planes must not coincide.
    x = x * 2.03f + 17.1f;
    y = y * 2.03f + 31.7f;
    z = z * 2.03f + 5.3f;
  }
  return sum / total;
}

SpotSample SampleSpot(const Eigen::Vector3f& point, uint32_t seed) {
  const Eigen::Vector3f corner = point.array().floor();
  const Eigen::Vector3i cell = corner.cast<int>();
  const uint32_t bits = HashLattice(cell.x(), cell.y(), cell.z(), seed);
  const float radius = 0.2f + 0.28f * ToUnsigned(bits);
  // The spot stays within its cell, so one cell is all to look at.
  const auto place = [&](uint32_t salt) {
    const uint32_t h = HashLattice(cell.x(), cell.y(), cell.z(), seed + salt);
    return radius + (1 - 2 * radius) * ToUnsigned(h);
  };
  const Eigen::Vector3f center(place(101), place(202), place(303));
  const float distance = (point - corner - center).norm();
  return {std::max(0.0f, 1 - distance / radius),
          ToUnsigned(bits * 0x9e3779b1u ^ (bits >> 7))};
}

}  // namespace octacut
