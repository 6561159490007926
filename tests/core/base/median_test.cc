#include "core/base/median.h"

#include <gtest/gtest.h>

namespace octacut {
namespace {

TEST(Median, IsTheMiddleOrTheUpperOneOfTwo) {
  EXPECT_EQ(Median(std::vector<double>{4}), 4);
  EXPECT_EQ(Median(std::vector<double>{9, -1, 4}), 4);
  EXPECT_EQ(Median(std::vector<float>{3, 1, 2, 7}), 3);
}

TEST(SpreadAroundMedian, IgnoresTheFewThatAreFarAway) {
  const MedianSpread spread =
      SpreadAroundMedian(std::vector<double>{5, 1000, 3, 4, 7});
  EXPECT_EQ(spread.median, 5);
  // Distances 0, 995, 2, 1 and 2.
  EXPECT_DOUBLE_EQ(spread.deviation, 2 * 1.4826);
}

}  // namespace
}  // namespace octacut
