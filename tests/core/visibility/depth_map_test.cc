#include "core/visibility/depth_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/visibility/bare_views.h"

namespace octacut {
namespace {

DepthMap MakeMap(float scale) {
  return DepthMap(testing::BareViews({Eigen::Vector3d::UnitX()})[0].projection,
                  scale);
}

TEST(DepthMap, KeepsTheNearestDepth) {
  DepthMap map = MakeMap(0.5f);
  EXPECT_EQ(map.At(100, 100), DepthMap::kEmpty);
  map.Splat(100, 100, 2, 5);
  EXPECT_EQ(map.At(100, 100), 5);
  map.Splat(101, 100, 2, 7);
  EXPECT_EQ(map.At(100, 100), 5);
  map.Splat(99, 101, 2, 3);
  EXPECT_EQ(map.At(100, 100), 3);
}

TEST(DepthMap, SplatsAreSquaresOfTheirRadius) {
  for (const float scale : {1.0f, 0.5f, 0.23f}) {
    DepthMap map = MakeMap(scale);
    const float radius = 3;
    map.Splat(120, 90, radius, 1);
    for (int y = 0; y < 180; ++y) {
      for (int x = 60; x < 180; ++x) {
        const float dx = std::abs(float(x) - 120) * scale;
        const float dy = std::abs(float(y) - 90) * scale;
        const float reach = std::max(dx, dy);
        if (reach < radius - 1) {
          EXPECT_EQ(map.At(float(x), float(y)), 1) << x << ", " << y;
        } else if (reach > radius + 1) {
          EXPECT_EQ(map.At(float(x), float(y)), DepthMap::kEmpty);
        }
      }
    }
  }
}

TEST(DepthMap, TheSmallestSplatHasAPixel) {
  DepthMap map = MakeMap(1);
  map.Splat(10.2f, 20.9f, 0.01f, 2);
  EXPECT_EQ(map.At(10.2f, 20.9f), 2);
  EXPECT_EQ(map.At(12.2f, 20.9f), DepthMap::kEmpty);
}

TEST(DepthMap, IsEmptyOutOfTheFrame) {
  DepthMap map = MakeMap(1);
  map.Splat(-5, 100, 20, 1);   // reaches in
  map.Splat(500, 500, 20, 1);  // does not
  EXPECT_EQ(map.At(2, 100), 1);
  EXPECT_EQ(map.At(-1, 100), DepthMap::kEmpty);
  EXPECT_EQ(map.At(100, -1), DepthMap::kEmpty);
  EXPECT_EQ(map.At(1e6f, 100), DepthMap::kEmpty);
  EXPECT_EQ(map.At(std::nanf(""), 100), DepthMap::kEmpty);
}

}  // namespace
}  // namespace octacut
