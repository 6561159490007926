#include "core/views/image_pyramid.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "tests/core/views/random_views.h"

namespace octacut {
namespace {

using testing::Random;

struct Picture {
  cv::Mat image;
  cv::Mat mask;

  // Channel 3 is the mask; the border is repeated.
  double At(int x, int y, int channel) const {
    x = std::clamp(x, 0, image.cols - 1);
    y = std::clamp(y, 0, image.rows - 1);
    return channel == 3 ? mask.at<uint8_t>(y, x)
                        : image.at<cv::Vec3b>(y, x)[channel];
  }
};

Picture RandomPicture(int width, int height, uint32_t seed) {
  Random random(seed);
  Picture picture{cv::Mat(height, width, CV_8UC3),
                  cv::Mat(height, width, CV_8UC1)};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int k = 0; k < 3; ++k) {
        picture.image.at<cv::Vec3b>(y, x)[k] = uint8_t(random.Integer(0, 255));
      }
      picture.mask.at<uint8_t>(y, x) = uint8_t(random.Integer(0, 255));
    }
  }
  return picture;
}

TEST(ImagePyramid, TexelsAreBoxFilteredPixels) {
  const Picture picture = RandomPicture(64, 96, 1);
  const ImagePyramid pyramid(picture.image, picture.mask);
  ASSERT_EQ(pyramid.NumLevels(), 4);  // 64, 32, 16, 8
  for (int k = 0; k < pyramid.NumLevels(); ++k) {
    const PyramidLevel& level = pyramid.Level(k);
    const int size = 1 << k;
    ASSERT_EQ(level.width, 64 / size);
    ASSERT_EQ(level.height, 96 / size);
    EXPECT_EQ(level.scale, 1.0f / float(size));
    for (int y = 0; y < level.height; ++y) {
      for (int x = 0; x < level.width; ++x) {
        // At its centre the bilinear sample is the texel itself.
        const Float4 sample = level.Sample((float(x) + 0.5f) * float(size),
                                           (float(y) + 0.5f) * float(size));
        for (int channel = 0; channel < 4; ++channel) {
          double mean = 0;
          for (int j = 0; j < size; ++j) {
            for (int i = 0; i < size; ++i) {
              mean += picture.At(x * size + i, y * size + j, channel);
            }
          }
          mean /= size * size;
          // Every level rounds to whole grey levels once.
          ASSERT_NEAR(sample[channel], mean, 0.5 * k + 1e-3)
              << "level " << k << " texel " << x << ", " << y;
        }
      }
    }
  }
}

TEST(ImagePyramid, SamplesAreBilinear) {
  const Picture picture = RandomPicture(37, 23, 2);
  const ImagePyramid pyramid(picture.image, picture.mask);
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const double u = random.Uniform(-3, 40);
    const double v = random.Uniform(-3, 26);
    const Float4 sample = pyramid.Level(0).Sample(float(u), float(v));
    const int x = int(std::floor(u - 0.5));
    const int y = int(std::floor(v - 0.5));
    const double fx = u - 0.5 - x;
    const double fy = v - 0.5 - y;
    for (int c = 0; c < 4; ++c) {
      const double expected = (1 - fy) * ((1 - fx) * picture.At(x, y, c) +
                                          fx * picture.At(x + 1, y, c)) +
                              fy * ((1 - fx) * picture.At(x, y + 1, c) +
                                    fx * picture.At(x + 1, y + 1, c));
      ASSERT_NEAR(sample[c], expected, 2e-2) << u << ", " << v;
    }
  }
}

// The same pixel coordinates mean the same place on all levels, even where
// sizes are odd.
TEST(ImagePyramid, ARampIsTheSameRampOnEveryLevel) {
  cv::Mat image(75, 101, CV_8UC3);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      image.at<cv::Vec3b>(y, x) =
          cv::Vec3b(uint8_t(2 * x), uint8_t(3 * y), uint8_t(x + y));
    }
  }
  const ImagePyramid pyramid(image, cv::Mat(image.size(), CV_8UC1, 255.0));
  Random random(4);
  for (int k = 0; k < pyramid.NumLevels(); ++k) {
    for (int i = 0; i < 200; ++i) {
      const double u = random.Uniform(16, 80);
      const double v = random.Uniform(16, 56);
      const Float4 sample = pyramid.Level(k).Sample(float(u), float(v));
      EXPECT_NEAR(sample[0], 2 * (u - 0.5), 0.6 * k + 1e-2);
      EXPECT_NEAR(sample[1], 3 * (v - 0.5), 0.6 * k + 1e-2);
      EXPECT_NEAR(sample[2], u + v - 1, 0.6 * k + 1e-2);
      EXPECT_EQ(sample[3], 255);
    }
  }
}

TEST(ImagePyramid, OddSizesRepeatTheBorder) {
  const Picture picture = RandomPicture(33, 17, 5);
  const ImagePyramid pyramid(picture.image, picture.mask);
  ASSERT_GE(pyramid.NumLevels(), 2);
  const PyramidLevel& half = pyramid.Level(1);
  ASSERT_EQ(half.width, 17);
  ASSERT_EQ(half.height, 9);
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      const Float4 texel = PyramidLevel::Unpack(half.texels[y * 17 + x]);
      for (int c = 0; c < 4; ++c) {
        double sum = 0;
        for (int k = 0; k < 4; ++k) {
          sum += picture.At(2 * x + (k & 1), 2 * y + k / 2, c);
        }
        ASSERT_NEAR(texel[c], sum / 4, 0.51);
      }
    }
  }
}

TEST(ImagePyramid, FootprintPicksTheNearestLevel) {
  const Picture picture = RandomPicture(128, 128, 6);
  const ImagePyramid pyramid(picture.image, picture.mask);
  ASSERT_EQ(pyramid.NumLevels(), 5);
  const auto level_of = [&](float footprint) {
    return int(&pyramid.LevelForFootprint(footprint) - &pyramid.Level(0));
  };
  EXPECT_EQ(level_of(0.01f), 0);
  EXPECT_EQ(level_of(1.0f), 0);
  EXPECT_EQ(level_of(1.4f), 0);
  EXPECT_EQ(level_of(1.5f), 1);
  EXPECT_EQ(level_of(2.7f), 1);
  EXPECT_EQ(level_of(4.0f), 2);
  EXPECT_EQ(level_of(1e6f), 4);
}

TEST(ImagePyramid, TheSmallestPictureWorks) {
  const Picture picture = RandomPicture(2, 2, 7);
  const ImagePyramid pyramid(picture.image, picture.mask);
  ASSERT_EQ(pyramid.NumLevels(), 1);
  for (const float u : {-1.0f, 0.5f, 1.5f, 9.0f}) {
    EXPECT_EQ(pyramid.Level(0).Sample(u, 1.5f)[0],
              picture.At(u < 1 ? 0 : 1, 1, 0));
  }
}

TEST(WeightChroma, LeavesGreyAndStretchesTheRest) {
  const Float4 color = WeightChroma(Float4{10, 20, 60, 7}, 3);  // grey of 30
  EXPECT_FLOAT_EQ(color[0], -30);
  EXPECT_FLOAT_EQ(color[1], 0);
  EXPECT_FLOAT_EQ(color[2], 120);
  EXPECT_FLOAT_EQ(color[3], 7);
}

TEST(ImagePyramid, RefusesOtherTypesAndSizes) {
  const cv::Mat image(8, 8, CV_8UC3, cv::Scalar::all(0));
  const cv::Mat mask(8, 8, CV_8UC1, cv::Scalar::all(0));
  EXPECT_THROW(ImagePyramid(mask, mask), InvariantError);
  EXPECT_THROW(ImagePyramid(image, image), InvariantError);
  EXPECT_THROW(ImagePyramid(image, mask.rowRange(0, 7)), InvariantError);
  EXPECT_THROW(ImagePyramid(image.colRange(0, 1), mask.colRange(0, 1)),
               InvariantError);
}

}  // namespace
}  // namespace octacut
