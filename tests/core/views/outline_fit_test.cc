#include "core/views/outline_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace octacut {
namespace {

constexpr int kNumSamples = 55;
constexpr int kMiddle = kNumSamples / 2;

// Light by the distance from the outline, pixels, positive inside.
struct Line {
  double step = 0;
  double root = 0;  // at a pixel from the outline
};

// Samples of a line of that kind on grey ground, blurred by a Gaussian and with
// noise; the outline lies `at` pixels behind the middle.
std::vector<Eigen::Vector3f> Samples(const Line& line,
                                     double at,
                                     double blur,
                                     std::mt19937* generator) {
  std::normal_distribution<double> noise(0, 0.5);
  std::vector<Eigen::Vector3f> samples;
  for (int i = 0; i < kNumSamples; ++i) {
    const double t = kEdgeStep * (i - kMiddle) - at;
    double light = 0;
    double weights = 0;
    for (int k = -60; k <= 60; ++k) {
      const double x = 0.05 * k;
      const double weight = std::exp(-0.5 * x * x);
      const double s = t + blur * x;
      light += s > 0 ? weight * (line.step + line.root * std::sqrt(s)) : 0;
      weights += weight;
    }
    const double value = 80 + light / weights;
    samples.emplace_back(float(value + noise(*generator)),
                         float(value + noise(*generator)),
                         float(value + noise(*generator)));
  }
  return samples;
}

// The mean distance of what is found from the outline, pixels.
double MeanError(const Line& line, double blur) {
  std::mt19937 generator(1);
  const OutlineFit fit(blur);
  double sum = 0;
  int count = 0;
  for (int k = -10; k <= 10; ++k) {
    const double at = 0.05 * k;
    const auto found =
        fit.Find(Samples(line, at, blur, &generator), kMiddle, false);
    EXPECT_TRUE(found);
    if (found && found->position) {
      sum += kEdgeStep * (*found->position - kMiddle) - at;
      ++count;
    }
  }
  EXPECT_GT(count, 15);
  return sum / count;
}

TEST(OutlineFit, IsWhereAStepIs) {
  for (const double blur : {0.6, 0.85, 1.2}) {
    EXPECT_NEAR(MeanError({.step = 60}, blur), 0, 0.05) << blur;
    EXPECT_NEAR(MeanError({.step = -60}, blur), 0, 0.05) << blur;
  }
}

TEST(OutlineFit, IsWhereASquareRootBegins) {
  for (const double blur : {0.6, 0.85, 1.2}) {
    EXPECT_NEAR(MeanError({.root = 50}, blur), 0, 0.25) << blur;
    EXPECT_NEAR(MeanError({.root = -50}, blur), 0, 0.25) << blur;
  }
}

TEST(OutlineFit, IsWhereBothAre) {
  EXPECT_NEAR(MeanError({.step = 40, .root = 20}, 0.85), 0, 0.1);
  EXPECT_NEAR(MeanError({.step = 60, .root = -20}, 0.85), 0, 0.1);
}

TEST(OutlineFit, LeavesLeastWithTheRightBlur) {
  for (const Line& line : {Line{.step = 60}, Line{.root = 50}}) {
    const auto share = [&](double blur) {
      std::mt19937 generator(1);
      const auto found = OutlineFit(blur).Find(
          Samples(line, 0.1, 0.8, &generator), kMiddle, false);
      return found ? found->residual_share : 1;
    };
    EXPECT_LT(share(0.8), share(0.52));
    EXPECT_LT(share(0.8), share(1.15));
  }
}

TEST(OutlineFit, IsNotFoundOutsideTheSearch) {
  std::mt19937 generator(1);
  const OutlineFit fit(0.6);
  const std::vector<Eigen::Vector3f> samples =
      Samples({.step = 60}, 0, 0.6, &generator);
  for (const int side : {-1, 1}) {
    const int near = kMiddle + side * int(2 / kEdgeStep);
    const auto found = fit.Find(samples, near, false);
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->position);
  }
  EXPECT_FALSE(fit.Find(samples, 0, true));
  EXPECT_FALSE(fit.Find(samples, kNumSamples - 1, true));
}

// Gloss that is as dark as the ground at the outline, and lighter inside.
TEST(OutlineFit, IsFartherOutsideInAWideSearch) {
  std::mt19937 generator(1);
  const OutlineFit fit(0.6);
  const auto samples = Samples({.step = -15, .root = 50}, 0, 0.6, &generator);
  const int inside = kMiddle + int(1.75f / kEdgeStep);
  const auto found = fit.Find(samples, inside, false);
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->position);
  const auto wide = fit.Find(samples, inside, true);
  ASSERT_TRUE(wide && wide->position);
  EXPECT_NEAR(*wide->position, kMiddle, 0.4);
}

}  // namespace
}  // namespace octacut
