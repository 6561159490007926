#include "core/evidence/window_sums.h"

#include <gtest/gtest.h>

#include "tests/core/views/random_views.h"

namespace octacut {
namespace {

struct Images {
  int width;
  int height;
  std::vector<float> values;
  std::vector<float> others;
};

Images RandomImages(int width, int height, uint32_t seed) {
  testing::Random random(seed);
  Images images{width, height, {}, {}};
  for (int i = 0; i < width * height; ++i) {
    images.values.push_back(float(random.Integer(-128, 127)));
    images.others.push_back(float(random.Integer(-128, 127)));
  }
  return images;
}

// Rows from y - radius on down to `last` at most; columns within the image.
void ExpectSums(
    const Images& images, const WindowSums& sums, int y, int first, int last) {
  const int radius = sums.Radius();
  for (int x = 0; x < images.width; ++x) {
    double value = 0, square = 0, product = 0;
    for (int j = std::max(first, y - radius); j <= std::min(last, y + radius);
         ++j) {
      for (int i = std::max(0, x - radius);
           i <= std::min(images.width - 1, x + radius);
           ++i) {
        const double v = images.values[j * images.width + i];
        value += v;
        square += v * v;
        product += v * images.others[j * images.width + i];
      }
    }
    // Whole numbers below 2^24: sums are exact.
    ASSERT_EQ(sums.Values()[x], value) << x << ", " << y;
    ASSERT_EQ(sums.Squares()[x], square) << x << ", " << y;
    ASSERT_EQ(sums.Products()[x], product) << x << ", " << y;
  }
}

TEST(WindowSums, AgreeWithBruteForce) {
  for (const int radius : {1, 2, 5}) {
    for (const int width : {1, 3, 40}) {
      const Images images = RandomImages(width, 20, uint32_t(radius * width));
      WindowSums sums(width, radius);
      EXPECT_FLOAT_EQ(sums.InverseCount(),
                      1.0f / float((2 * radius + 1) * (2 * radius + 1)));
      for (int round = 0; round < 2; ++round) {  // Clear begins anew
        sums.Clear();
        for (int y = 0; y < images.height; ++y) {
          sums.Push(images.values.data() + y * width,
                    images.others.data() + y * width);
          if (y >= radius) {
            sums.Sum();
            ExpectSums(images, sums, y - radius, 0, y);
          }
        }
      }
    }
  }
}

TEST(WindowSums, HoldFewerSamplesNearTheFirstRow) {
  const Images images = RandomImages(16, 4, 7);
  WindowSums sums(16, 3);
  for (int y = 0; y < 4; ++y) {
    sums.Push(images.values.data() + y * 16, images.others.data() + y * 16);
    sums.Sum();
    ExpectSums(images, sums, y - 3, 0, y);
  }
}

}  // namespace
}  // namespace octacut
