#include "core/refine/border_terms.h"

#include <gtest/gtest.h>

#include <cmath>

namespace octacut {
namespace {

// Pixels per unit.
constexpr float kPixelsPerUnit = 200;
constexpr int kCount = 2000;

// Occluding contours between two planes. The border of the mask is
// `distance(i)` pixels outside of the i-th one, and photographs find the
// surface `offset` pixels outside.
BorderVerdict JudgeAt(float (*distance)(int),
                      float offset = 0,
                      bool knows_most = true) {
  std::vector<ContourTarget> contours;
  contours.reserve(kCount);
  for (int i = 0; i < kCount; ++i) {
    contours.push_back(
        {{{0, 1}, 0.5f, distance(i) / kPixelsPerUnit, 1}, kPixelsPerUnit});
  }
  OffsetMeasurement measured;
  measured.offset = offset / kPixelsPerUnit;
  measured.weight = 4;
  return JudgeBorders(contours,
                      std::vector<LocalSurface>(2),
                      {measured, measured},
                      {.scale = 1},
                      knows_most);
}

float SmallNoise(int i) { return 0.2f * std::sin(float(i)); }

float NoiseAndBites(int i) { return i % 40 == 0 ? -1.2f : SmallNoise(i); }

TEST(JudgeBorders, LetsVerticesLeaveMasksByTheUsualDistance) {
  EXPECT_NEAR(JudgeAt(SmallNoise).hull_tolerance, 0.28, 0.02);
}

TEST(JudgeBorders, LetsVerticesLeaveBitesOfMasks) {
  EXPECT_NEAR(JudgeAt(NoiseAndBites).hull_tolerance, 1.2, 0.01);
  EXPECT_NEAR(JudgeAt(NoiseAndBites).shift, 0, 0.01);
}

// Where offsets say that the masks are wrong as a whole, or most points have
// none, there may be no bites.
TEST(JudgeBorders, DoesNotTakeWrongOffsetsForBites) {
  EXPECT_NEAR(JudgeAt(NoiseAndBites, -1).hull_tolerance, 0.28, 0.02);
  EXPECT_NEAR(JudgeAt(NoiseAndBites, 0, false).hull_tolerance, 0.28, 0.02);
}

float LargeNoise(int i) { return 3 * SmallNoise(i); }

// Where photographs know little, contours are all there is, and weigh as much
// as they are known.
TEST(JudgeBorders, WeighsContoursMoreWhereMostPointsHaveNoOffset) {
  EXPECT_EQ(JudgeAt(SmallNoise).contour_weight, 1);
  EXPECT_EQ(JudgeAt(SmallNoise, 0, false).contour_weight, 2);
  const double weight = JudgeAt(LargeNoise, 0, false).contour_weight;
  EXPECT_GT(weight, 1);
  EXPECT_LT(weight, 1.3);
}

}  // namespace
}  // namespace octacut
