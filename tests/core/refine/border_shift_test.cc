#include "core/refine/border_shift.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace octacut {
namespace {

// Pixels per unit.
constexpr float kScale = 200;

// Occluding contours between points 0 and 1, a third of the way; the target in
// pixels.
std::vector<ContourTarget> Contours(size_t count, float target) {
  return std::vector<ContourTarget>(
      count, {{{0, 1}, 1.0f / 3, target / kScale, 1}, kScale});
}

// In pixels.
OffsetMeasurement Measured(float offset, float weight) {
  OffsetMeasurement measurement;
  measurement.offset = offset / kScale;
  measurement.weight = weight;
  return measurement;
}

// On planes.
std::optional<BorderExcess> Excess(
    const std::vector<ContourTarget>& contours,
    const std::vector<OffsetMeasurement>& measurements) {
  const std::vector<LocalSurface> surfaces(measurements.size());
  return MeasureExcess(contours, surfaces, measurements, 4);
}

TEST(MeasureExcess, IsWhatContoursLeadFartherOutward) {
  const std::vector<OffsetMeasurement> measurements = {Measured(0.3f, 4),
                                                       Measured(0.6f, 5)};
  EXPECT_NEAR(
      Excess(Contours(100, 0.9f), measurements).value().median, 0.5, 1e-6);
  EXPECT_NEAR(
      Excess(Contours(100, -0.2f), measurements).value().median, -0.6, 1e-6);
}

TEST(MeasureExcess, IsThatOfTheBestMeasuredMajority) {
  std::vector<OffsetMeasurement> measurements = {
      Measured(0, 4), Measured(0, 8), Measured(0, 2), Measured(0, 8)};
  std::vector<ContourTarget> contours = Contours(101, 0.5f);
  for (const ContourTarget& contour : Contours(100, 3)) {
    contours.push_back(contour);
  }
  EXPECT_NEAR(Excess(contours, measurements).value().median, 0.5, 1e-6);
  // Fifteen times as many occluding contours of half the weight do not outvote
  // the rest.
  contours.resize(101);
  for (ContourTarget contour : Contours(1500, 3)) {
    contour.edge.points = {2, 3};
    contours.push_back(contour);
  }
  EXPECT_NEAR(Excess(contours, measurements).value().median, 0.5, 1e-6);
  std::reverse(contours.begin(), contours.end());
  EXPECT_NEAR(Excess(contours, measurements).value().median, 0.5, 1e-6);
  measurements[2].weight = 4;
  EXPECT_NEAR(Excess(contours, measurements).value().median, 3, 1e-6);
}

TEST(MeasureExcess, SaysHowFarAHundredthLiesInside) {
  const std::vector<OffsetMeasurement> measurements = {Measured(0.1f, 8),
                                                       Measured(0.1f, 8)};
  std::vector<ContourTarget> contours = Contours(1000, 0);
  for (const ContourTarget& contour : Contours(30, -1.7f)) {
    contours.push_back(contour);
  }
  EXPECT_NEAR(Excess(contours, measurements).value().bites, 1.8, 1e-6);
  contours.resize(1005);
  EXPECT_NEAR(Excess(contours, measurements).value().bites, 0.1, 1e-6);
}

TEST(MeasureExcess, SaysHowWellContoursAgree) {
  const std::vector<OffsetMeasurement> measurements = {
      Measured(0, 8), Measured(0, 8), Measured(0, 2)};
  EXPECT_NEAR(
      Excess(Contours(100, 0.9f), measurements).value().deviation, 0, 1e-6);
  std::vector<ContourTarget> contours = Contours(101, 0.5f);
  for (const float target : {0.3f, 0.6f}) {
    for (const ContourTarget& contour : Contours(60, target)) {
      contours.push_back(contour);
    }
  }
  EXPECT_NEAR(Excess(contours, measurements).value().median, 0.5, 1e-6);
  EXPECT_NEAR(Excess(contours, measurements).value().deviation, 0.1, 1e-6);
  // Those that are measured worse count less.
  for (ContourTarget contour : Contours(1500, 3)) {
    contour.edge.points = {1, 2};
    contours.push_back(contour);
  }
  EXPECT_NEAR(Excess(contours, measurements).value().deviation, 0.1, 1e-6);
}

TEST(MeasureExcess, IsInPixelsOfEachView) {
  std::vector<ContourTarget> contours = Contours(100, 0.8f);
  for (ContourTarget& contour : contours) {
    contour.pixels_per_unit = 2 * kScale;
  }
  EXPECT_NEAR(
      Excess(contours, {Measured(0.3f, 4), Measured(0.3f, 5)}).value().median,
      1,
      1e-6);
}

TEST(MeasureExcess, LeavesOutThinStructures) {
  std::vector<LocalSurface> surfaces(2);
  surfaces[1].uu = -0.5f * kScale / 5;  // a cylinder of radius 5 pixels
  const std::vector<OffsetMeasurement> measurements = {Measured(0, 1),
                                                       Measured(0, 1)};
  EXPECT_TRUE(MeasureExcess(Contours(100, 1), surfaces, measurements, 4.9));
  EXPECT_FALSE(MeasureExcess(Contours(100, 1), surfaces, measurements, 5.1));
}

TEST(MeasureExcess, NeedsContoursWithOffsets) {
  std::vector<ContourTarget> contours = Contours(200, 1);
  const std::vector<OffsetMeasurement> few = {
      Measured(0, 1), Measured(0, 1), Measured(0, 0)};
  EXPECT_TRUE(Excess(contours, few));
  for (ContourTarget contour : Contours(2000, 1)) {
    contour.edge.points = {1, 2};
    contours.push_back(contour);
  }
  EXPECT_FALSE(Excess(contours, few));
  EXPECT_FALSE(Excess({}, {}));
  EXPECT_FALSE(Excess(Contours(99, 1), {Measured(0, 1), Measured(0, 1)}));
  EXPECT_FALSE(Excess(Contours(1000, 1), {Measured(0, 1), Measured(0, 0)}));
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
