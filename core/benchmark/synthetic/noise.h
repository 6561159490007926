// Deterministic noise over space, and random deviates from hashes.
#pragma once

#include <cstdint>
#include <Eigen/Core>

#include "core/raycast/sampling.h"

namespace octacut {

// Standard normal deviate.
double HashNormal(uint64_t bits);

// Smooth noise over space in [-1, 1] with one feature about a unit of length
// (quintic interpolation of random values at the integer lattice): the sum of
// `octaves` of it, each of half the size and strength of the one before.
float FractalNoise(const Eigen::Vector3f& point, int octaves, uint32_t seed);

// Spots, one in each unit cell: how deep inside its cell's spot the point is
// (1 at the centre, 0 at the border and outside), and a number in [0, 1) that
// belongs to the spot.
struct SpotSample {
  float depth;
  float choice;
};
SpotSample SampleSpot(const Eigen::Vector3f& point, uint32_t seed);

}  // namespace octacut
