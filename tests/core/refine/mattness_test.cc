#include "core/refine/mattness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace octacut {
namespace {

TEST(Mattness, IsOneWhereAllViewsShowTheSame) {
  EXPECT_EQ(Mattness({100, 100, 100, 100}), 1);
  EXPECT_EQ(Mattness({100.6f, 99.5f, 100, 101, 99.2f, 100.1f}), 1);
}

TEST(Mattness, IsOneWithoutViewsToCompare) {
  EXPECT_EQ(Mattness({}), 1);
  EXPECT_EQ(Mattness({100}), 1);
}

TEST(Mattness, IsHighUnderALightThatMovesWithTheCamera) {
  constexpr double kDegree = 0.0174532925;
  std::vector<float> brightness;
  for (int angle = -50; angle <= 50; angle += 10) {
    brightness.push_back(float(160 * std::cos(angle * kDegree)));
  }
  EXPECT_GT(Mattness(brightness), 0.9f);
}

TEST(Mattness, IsZeroWhereFewViewsShowAHighlight) {
  EXPECT_EQ(Mattness({120, 121, 119, 120, 185, 120.5f, 119.5f, 120}), 0);
  // Few grey levels are enough: noise is smaller.
  EXPECT_EQ(Mattness({120, 120.4f, 119.7f, 120, 128, 120.5f, 119.8f, 120}), 0);
}

TEST(Mattness, IsZeroWhereBrightnessChangesByMoreThanShadingCan) {
  EXPECT_EQ(Mattness({40, 180, 60, 200, 90, 30, 150, 210}), 0);
}

TEST(Mattness, DoesNotDependOnTheOrder) {
  EXPECT_NEAR(Mattness({97, 110, 104, 128, 100}),
              Mattness({128, 100, 97, 104, 110}),
              1e-4);
}

TEST(Mattness, IsANumberWhereAllIsBlack) {
  EXPECT_EQ(Mattness({0, 0, 0}), 1);
  EXPECT_EQ(Mattness({0, 0, 0, 0, 10}), 0);
}

}  // namespace
}  // namespace octacut
