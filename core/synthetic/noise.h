// Deterministic randomness: a hash instead of a generator with a state, so
// that any thread may draw any number in any order.
#pragma once

#include <cstdint>
#include <Eigen/Core>

namespace octacut {

// A well mixed 64-bit hash (the finalizer of splitmix64) of a chain of
// numbers.
inline uint64_t HashBits(uint64_t value) {
  value += 0x9e3779b97f4a7c15u;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}
template <typename... Rest>
uint64_t HashBits(uint64_t first, uint64_t second, Rest... rest) {
  return HashBits(HashBits(first) ^ second, rest...);
}

// Uniform in [0, 1).
inline double HashUniform(uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}
// Standard normal deviate.
double HashNormal(uint64_t bits);
// Uniform on the unit sphere.
Eigen::Vector3d HashDirection(uint64_t bits);

// Smooth noise over space in [-1, 1] with one feature about a unit of length
// (quintic interpolation of random values at the integer lattice).
float ValueNoise(const Eigen::Vector3f& point, uint32_t seed);

// Sum of `octaves` noises, each of half the size and strength of the one
// before; in [-1, 1].
float FractalNoise(const Eigen::Vector3f& point, int octaves, uint32_t seed);

// Spots, one in each unit cell: how deep inside its cell's spot the point is
// (1 at the centre, 0 at the rim and outside), and a number in [0, 1) that
// belongs to the spot.
struct SpotSample {
  float depth;
  float choice;
};
SpotSample SampleSpot(const Eigen::Vector3f& point, uint32_t seed);

}  // namespace octacut
