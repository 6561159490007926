#include "core/base/median.h"

#include <gtest/gtest.h>

namespace octacut {
namespace {

TEST(Median, IsTheMiddleOrTheUpperOneOfTwo) {
  EXPECT_EQ(Median(std::vector<double>{4}), 4);
  EXPECT_EQ(Median(std::vector<double>{9, -1, 4}), 4);
  EXPECT_EQ(Median(std::vector<float>{3, 1, 2, 7}), 3);
}

}  // namespace
}  // namespace octacut
