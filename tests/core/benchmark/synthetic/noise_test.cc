#include "core/benchmark/synthetic/noise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/benchmark/synthetic/texture.h"

namespace octacut {
namespace {

TEST(HashNormal, HasMeanZeroAndVarianceOne) {
  double sum = 0;
  double squares = 0;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const double x = HashNormal(HashBits(5, i));
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / kCount, 0, 0.03);
  EXPECT_NEAR(squares / kCount, 1, 0.05);
}

TEST(FractalNoise, OfOneOctaveIsContinuousAndBounded) {
  const float step = 1e-3f;
  for (int i = -4000; i < 4000; ++i) {
    const Eigen::Vector3f point(i * 2 * step, 0.3f, -0.7f);
    const float here = FractalNoise(point, 1, 3);
    const float there = FractalNoise(point + Eigen::Vector3f(step, 0, 0), 1, 3);
    EXPECT_LE(std::abs(here), 1);
    EXPECT_LT(std::abs(here - there), 5 * step);
  }
}

TEST(FractalNoise, VariesAndStaysInRange) {
  float low = 1;
  float high = -1;
  for (int i = 0; i < 2000; ++i) {
    const float value = FractalNoise({0.37f * i, -0.11f * i, 0.5f}, 4, 9);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  EXPECT_LT(low, -0.3f);
  EXPECT_GT(high, 0.3f);
  EXPECT_GE(low, -1.0f);
  EXPECT_LE(high, 1.0f);
}

TEST(TextureColor, ContrastGoesFromPlainToFull) {
  for (const TextureKind kind :
       {TextureKind::kMarble, TextureKind::kSpeckle, TextureKind::kPainted}) {
    TextureOptions options;
    options.kind = kind;
    const auto deviation = [&] {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      double squares = 0;
      constexpr int kCount = 2000;
      for (int i = 0; i < kCount; ++i) {
        const Eigen::Vector3f color =
            TextureColor(options, {0.013f * i, 0.007f * i, 0.2f});
        EXPECT_GE(color.minCoeff(), 0);
        EXPECT_LE(color.maxCoeff(), 1);
        sum += color.cast<double>();
        squares += color.cast<double>().squaredNorm();
      }
      return std::sqrt(
          std::max(0.0, squares / kCount - (sum / kCount).squaredNorm()));
    };
    const double full = deviation();
    options.contrast = 0.3;
    const double weak = deviation();
    options.contrast = 0;
    EXPECT_NEAR(deviation(), 0, 1e-3);
    EXPECT_GT(full, 0.1);
    EXPECT_GT(weak, 0.02);
    EXPECT_LT(weak, 0.5 * full);
  }
}

TEST(TextureColor, PlainPartsHaveOneColorAndTheShareAskedFor) {
  TextureOptions textured;
  TextureOptions patchy = textured;
  patchy.plain_share = 0.4;
  patchy.plain_size = 0.1;
  int num_plain = 0;
  constexpr int kSide = 40;
  for (int i = 0; i < kSide * kSide; ++i) {
    const Eigen::Vector3f middle(0.1f * float(i % kSide) - 1.95f,
                                 0.1f * float(i / kSide) - 1.95f,
                                 0.05f);
    const Eigen::Vector3f color = TextureColor(patchy, middle);
    const bool plain = color == patchy.color;
    num_plain += plain;
    if (plain) {  // all of its cube
      EXPECT_EQ(TextureColor(patchy, middle + Eigen::Vector3f(0.04f, 0, 0)),
                patchy.color);
    } else {
      EXPECT_EQ(color, TextureColor(textured, middle));
    }
  }
  EXPECT_NEAR(num_plain / double(kSide * kSide), 0.4, 0.04);
}

TEST(TextureOptions, RefusesBadValues) {
  TextureOptions options;
  options.contrast = 1.5;
  EXPECT_THROW(options.Check(), OptionError);
  options = {};
  options.scale = 0;
  EXPECT_THROW(options.Check(), OptionError);
  options = {};
  options.color = {0.5f, 1.2f, 0.5f};
  EXPECT_THROW(options.Check(), OptionError);
  EXPECT_NO_THROW(TextureOptions{}.Check());
}

}  // namespace
}  // namespace octacut
