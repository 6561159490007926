#include "core/refine/border_shift.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace octacut {
namespace {

// Rims between places 0 and 1, a third of the way.
std::vector<EdgeTarget> Rims(size_t count, float target) {
  return std::vector<EdgeTarget>(count, {{0, 1}, 1.0f / 3, target, 1});
}

OffsetMeasurement Measured(float offset, float weight) {
  OffsetMeasurement measurement;
  measurement.offset = offset;
  measurement.weight = weight;
  return measurement;
}

TEST(MedianExcess, IsWhatRimsLeadFartherOutward) {
  const std::vector<OffsetMeasurement> measurements = {Measured(0.3f, 4),
                                                       Measured(0.6f, 5)};
  EXPECT_NEAR(MedianExcess(Rims(100, 0.9f), measurements).value(), 0.5, 1e-6);
  EXPECT_NEAR(MedianExcess(Rims(100, -0.2f), measurements).value(), -0.6, 1e-6);
}

TEST(MedianExcess, IsThatOfTheBestMeasuredMajority) {
  std::vector<OffsetMeasurement> measurements = {
      Measured(0, 4), Measured(0, 8), Measured(0, 2), Measured(0, 8)};
  std::vector<EdgeTarget> rims = Rims(101, 0.5f);
  for (const EdgeTarget& rim : Rims(100, 3)) {
    rims.push_back(rim);
  }
  EXPECT_NEAR(MedianExcess(rims, measurements).value(), 0.5, 1e-6);
  // Fifteen times as many rims of half the weight do not outvote the rest.
  rims.resize(101);
  for (EdgeTarget rim : Rims(1500, 3)) {
    rim.places = {2, 3};
    rims.push_back(rim);
  }
  EXPECT_NEAR(MedianExcess(rims, measurements).value(), 0.5, 1e-6);
  std::reverse(rims.begin(), rims.end());
  EXPECT_NEAR(MedianExcess(rims, measurements).value(), 0.5, 1e-6);
  measurements[2].weight = 4;
  EXPECT_NEAR(MedianExcess(rims, measurements).value(), 3, 1e-6);
}

TEST(MedianExcess, NeedsRimsWithOffsets) {
  EXPECT_FALSE(MedianExcess({}, {}));
  EXPECT_FALSE(MedianExcess(Rims(99, 1), {Measured(0, 1), Measured(0, 1)}));
  EXPECT_FALSE(MedianExcess(Rims(1000, 1), {Measured(0, 1), Measured(0, 0)}));
}

TEST(ShrinkShift, TakesWhatIsBelowTheNoiseForNoise) {
  EXPECT_EQ(ShrinkShift(0, 0.3), 0);
  EXPECT_EQ(ShrinkShift(0, 0), 0);
  EXPECT_EQ(ShrinkShift(0.7, 0), 0.7);
  EXPECT_LT(ShrinkShift(0.1, 0.3), 0.011);
  EXPECT_NEAR(ShrinkShift(0.3, 0.3), 0.15, 1e-12);
  EXPECT_GT(ShrinkShift(2, 0.3), 1.95);
  EXPECT_EQ(ShrinkShift(-2, 0.3), -ShrinkShift(2, 0.3));
  EXPECT_LT(ShrinkShift(2, 1e3), 1e-4);
}

}  // namespace
}  // namespace octacut
