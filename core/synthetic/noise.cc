#include "core/synthetic/noise.h"

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

Eigen::Vector3d HashDirection(uint64_t bits) {
  const double z = 2 * HashUniform(HashBits(bits, 1)) - 1;
  const double angle = 2 * std::numbers::pi * HashUniform(HashBits(bits, 2));
  const double radius = std::sqrt(std::max(0.0, 1 - z * z));
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

float ValueNoise(const Eigen::Vector3f& point, uint32_t seed) {
  const float floor_x = std::floor(point.x());
  const float floor_y = std::floor(point.y());
  const float floor_z = std::floor(point.z());
  const auto x = static_cast<int32_t>(floor_x);
  const auto y = static_cast<int32_t>(floor_y);
  const auto z = static_cast<int32_t>(floor_z);
  const float u = Fade(point.x() - floor_x);
  const float v = Fade(point.y() - floor_y);
  const float w = Fade(point.z() - floor_z);
  const auto at = [&](int dx, int dy, int dz) {
    return ToSigned(HashLattice(x + dx, y + dy, z + dz, seed));
  };
  const float low = Mix(
      Mix(at(0, 0, 0), at(1, 0, 0), u), Mix(at(0, 1, 0), at(1, 1, 0), u), v);
  const float high = Mix(
      Mix(at(0, 0, 1), at(1, 0, 1), u), Mix(at(0, 1, 1), at(1, 1, 1), u), v);
  return Mix(low, high, w);
}

float FractalNoise(const Eigen::Vector3f& point, int octaves, uint32_t seed) {
  float sum = 0;
  float strength = 1;
  float total = 0;
  Eigen::Vector3f scaled = point;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += strength * ValueNoise(scaled, seed + static_cast<uint32_t>(octave));
    total += strength;
    strength *= 0.5f;
    // Not exactly 2 and shifted: the lattices' planes must not coincide.
    scaled = scaled * 2.03f + Eigen::Vector3f(17.1f, 31.7f, 5.3f);
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
