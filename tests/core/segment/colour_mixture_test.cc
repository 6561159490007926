#include "core/segment/colour_mixture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/hash.h"

namespace octacut {
namespace {

// About normal, standard deviation 1.
float Noise(uint64_t seed) {
  float sum = 0;
  for (uint64_t i = 0; i < 12; ++i) {
    sum += float(HashUniform(HashBits(seed, i)));
  }
  return sum - 6;
}

std::vector<PixelFeature> Cluster(const PixelFeature& mean,
                                  float deviation,
                                  size_t count) {
  std::vector<PixelFeature> samples;
  for (size_t i = 0; i < count; ++i) {
    PixelFeature& sample = samples.emplace_back(mean);
    for (int c = 0; c < 4; ++c) {
      sample[c] += deviation * Noise(HashBits(i, uint64_t(c)));
    }
  }
  return samples;
}

TEST(ColourMixture, DensityIsThatOfTheSamples) {
  const PixelFeature mean = {50, 10, -10, 5};
  const ColourMixture mixture(Cluster(mean, 3, 4000), 1);
  // A variance of 9 and the least one of 1.
  const double peak = 1 / (4 * M_PI * M_PI * 10 * 10);
  EXPECT_NEAR(mixture.Density(mean) / peak, 0.99, 0.05);
  const PixelFeature beside = {50 + 4, 10, -10, 5};
  EXPECT_NEAR(mixture.Density(beside) / mixture.Density(mean),
              std::exp(-0.5 * 16 / 10),
              0.05);
}

TEST(ColourMixture, FindsEveryCluster) {
  std::vector<PixelFeature> samples = Cluster({20, 0, 0, 2}, 1, 900);
  const std::vector<PixelFeature> rare = Cluster({80, 30, 5, 9}, 1, 100);
  samples.insert(samples.end(), rare.begin(), rare.end());
  const ColourMixture mixture(samples, 4);
  EXPECT_NEAR(
      mixture.Density({20, 0, 0, 2}) / mixture.Density({80, 30, 5, 9}), 9, 2);
  EXPECT_LT(mixture.Density({50, 15, 2, 5}), 1e-3 * mixture.Density(rare[0]));
}

TEST(ColourMixture, WhatWasNeverSeenDecidesNothing) {
  const ColourMixture a(Cluster({20, 0, 0, 2}, 1, 500), 3);
  const ColourMixture b(Cluster({80, 0, 0, 2}, 1, 500), 3);
  const PixelFeature strange = {50, 70, -70, 20};
  EXPECT_FLOAT_EQ(a.Density(strange), b.Density(strange));
  EXPECT_GT(ColourMixture().Density(strange), 0);
}

TEST(ColourMixture, OfOneColourIsFinite) {
  const std::vector<PixelFeature> samples(300, PixelFeature(0, 0, 0, 0));
  const ColourMixture mixture(samples, 6);
  EXPECT_TRUE(std::isfinite(mixture.Density({0, 0, 0, 0})));
  EXPECT_GT(mixture.Density({0, 0, 0, 0}), mixture.Density({3, 0, 0, 0}));
}

}  // namespace
}  // namespace octacut
