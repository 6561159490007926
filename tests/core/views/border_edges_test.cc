#include "core/views/border_edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tests/core/views/random_views.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::Random;

constexpr int kSize = 240;
constexpr double kRadius = 80;

// The share of a pixel's area that a disc around the middle covers.
double Coverage(int x, int y, double radius) {
  constexpr int kSamples = 8;
  int count = 0;
  for (int i = 0; i < kSamples * kSamples; ++i) {
    const double u = x + (i % kSamples + 0.5) / kSamples - kSize / 2.0;
    const int row = i / kSamples;
    const double v = y + (row + 0.5) / kSamples - kSize / 2.0;
    count += u * u + v * v < radius * radius ? 1 : 0;
  }
  return double(count) / (kSamples * kSamples);
}

uint8_t Grey(double linear) {
  return uint8_t(std::lround(255 * std::pow(linear, 1 / 2.2)));
}

PreparedView ViewOf(const cv::Mat& image, const cv::Mat& mask) {
  PreparedView view;
  view.silhouette = Silhouette(mask);
  view.pyramid = ImagePyramid(image, mask);
  return view;
}

// A disc of linear light `object` before `background`, and a mask whose disc is
// larger by `shift` pixels; `noise` grey levels at most.
PreparedView MakeView(double shift,
                      double object,
                      double background,
                      int noise = 2) {
  Random random(7);
  cv::Mat image(kSize, kSize, CV_8UC3);
  cv::Mat mask(kSize, kSize, CV_8UC1);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double covered = Coverage(x, y, kRadius);
      const double light =
          std::min(1.0, covered * object + (1 - covered) * background);
      for (int c = 0; c < 3; ++c) {
        image.at<cv::Vec3b>(y, x)[c] = cv::saturate_cast<uint8_t>(
            Grey(light) + random.Integer(-noise, noise));
      }
      mask.at<uint8_t>(y, x) =
          uint8_t(std::lround(255 * Coverage(x, y, kRadius + shift)));
    }
  }
  return ViewOf(image, mask);
}

// The same of a photograph that is blurred by `kernel`, in linear light.
PreparedView MakeBlurredView(double shift, const cv::Mat& kernel) {
  Random random(7);
  cv::Mat light(kSize, kSize, CV_64FC1);
  cv::Mat mask(kSize, kSize, CV_8UC1);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      light.at<double>(y, x) = 0.2 + 0.5 * Coverage(x, y, kRadius);
      mask.at<uint8_t>(y, x) =
          uint8_t(std::lround(255 * Coverage(x, y, kRadius + shift)));
    }
  }
  cv::filter2D(light, light, -1, kernel / cv::sum(kernel)[0]);
  cv::Mat image(kSize, kSize, CV_8UC3);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      for (int c = 0; c < 3; ++c) {
        image.at<cv::Vec3b>(y, x)[c] = cv::saturate_cast<uint8_t>(
            Grey(light.at<double>(y, x)) + random.Integer(-1, 1));
      }
    }
  }
  return ViewOf(image, mask);
}

cv::Mat Gaussian(double deviation) {
  const cv::Mat line = cv::getGaussianKernel(21, deviation);
  return line * line.t();
}

// Out of focus.
cv::Mat Disc(int radius) {
  cv::Mat kernel = cv::Mat::zeros(2 * radius + 1, 2 * radius + 1, CV_64FC1);
  cv::circle(kernel, {radius, radius}, radius, 1, cv::FILLED);
  return kernel;
}

TEST(MeasureBorderEdges, FindsTheShiftOfMasks) {
  for (const double shift : {-2.3, -0.5, 0.0, 0.4, 3.6}) {
    for (const double object : {0.02, 0.7}) {
      const ViewSet views = {MakeView(shift, object, 0.2)};
      const auto edges = MeasureBorderEdges(views, Context(2));
      ASSERT_TRUE(edges) << shift;
      EXPECT_NEAR(edges->shift, shift, 0.05) << shift << " " << object;
      EXPECT_GT(edges->share, 0.9);
      EXPECT_LT(edges->deviation, 0.2);
    }
  }
}

TEST(MeasureBorderEdges, FindsTheShiftInBlurredPhotographs) {
  for (const cv::Mat& kernel : {Gaussian(0.6),
                                Gaussian(0.9),
                                Gaussian(1.3),
                                Gaussian(1.8),
                                Gaussian(2.5),
                                Disc(1),
                                Disc(2),
                                Disc(3)}) {
    const auto edges =
        MeasureBorderEdges({MakeBlurredView(0.7, kernel)}, Context(1));
    ASSERT_TRUE(edges);
    EXPECT_NEAR(edges->shift, 0.7, 0.1) << kernel.rows;
  }
}

TEST(MeasureBorderEdges, DoesNotAskClippedEdges) {
  // Four times as bright as what is clipped: the disc looks half a pixel
  // larger.
  const ViewSet views = {MakeView(0, 4, 0.1)};
  EXPECT_FALSE(MeasureBorderEdges(views, Context(1)));
}

// A disc whose mask is too large by `shift` pixels, with a stronger edge so
// many pixels inside its outline: porcelain mirrors the background at grazing
// angles.
PreparedView MakeViewWithReflection(double shift, double inside_pixels) {
  cv::Mat image(kSize, kSize, CV_8UC3);
  cv::Mat mask(kSize, kSize, CV_8UC1);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double rim = Coverage(x, y, kRadius);
      const double inside = Coverage(x, y, kRadius - inside_pixels);
      image.at<cv::Vec3b>(y, x) = cv::Vec3b::all(
          Grey((1 - rim) * 0.5 + (rim - inside) * 0.4 + inside * 0.25));
      mask.at<uint8_t>(y, x) =
          uint8_t(std::lround(255 * Coverage(x, y, kRadius + shift)));
    }
  }
  PreparedView view;
  view.silhouette = Silhouette(mask);
  view.pyramid = ImagePyramid(image, mask);
  return view;
}

TEST(MeasureBorderEdges, PrefersTheOutlineToAStrongerEdgeOfAReflection) {
  const auto edges =
      MeasureBorderEdges({MakeViewWithReflection(0.4, 3)}, Context(1));
  ASSERT_TRUE(edges);
  EXPECT_NEAR(edges->shift, 0.4, 0.1);
}

// The steepest edges of this torus lie 0.6 pixels inside its outline.
TEST(MeasureBorderEdges, FindsTheOutlineOfGlaze) {
  SceneSpec spec = testing::TestSpec("torus", 640, 480, 3);
  spec.material = MaterialKind::kPorcelain;
  spec.degrade.pixel_noise = 1;
  const auto edges =
      MeasureBorderEdges(testing::MakeTestScene(spec).views, Context(2));
  ASSERT_TRUE(edges);
  EXPECT_NEAR(edges->shift, 0, 0.1);
}

TEST(MeasureBorderEdges, SeesNoPeakInNoise) {
  const ViewSet views = {MakeView(0, 0.2, 0.2, 40)};
  EXPECT_FALSE(MeasureBorderEdges(views, Context(1)));
}

TEST(MeasureBorderEdges, SeesNothingWithoutContrast) {
  const ViewSet views = {MakeView(0, 0.2, 0.2, 1)};
  EXPECT_FALSE(MeasureBorderEdges(views, Context(1)));
}

TEST(ShiftBordersToEdges, GivesTheShiftToAllViews) {
  ViewSet views = {MakeView(0.6, 0.6, 0.1), MakeView(0.6, 0.6, 0.1)};
  views[0].border_shift = 9;
  const auto edges = ShiftBordersToEdges(Context(2), &views);
  ASSERT_TRUE(edges);
  for (const PreparedView& view : views) {
    EXPECT_FLOAT_EQ(view.border_shift, float(edges->shift));
    EXPECT_FLOAT_EQ(view.border_shift_slack, 0.1f);
  }
  ViewSet large = {MakeView(3, 0.6, 0.1)};
  ShiftBordersToEdges(Context(1), &large);
  EXPECT_NEAR(large[0].border_shift, 3, 0.2);
  EXPECT_FLOAT_EQ(large[0].border_shift_slack, 0.1f);
  // Beyond the largest shift.
  ViewSet largest = {MakeView(5.6, 0.6, 0.1)};
  ShiftBordersToEdges(Context(1), &largest);
  EXPECT_EQ(largest[0].border_shift, 5);
  EXPECT_TRUE(std::isinf(largest[0].border_shift_slack));
  views[0].pyramid = ImagePyramid();
  views[1].pyramid = ImagePyramid();
  EXPECT_FALSE(ShiftBordersToEdges(Context(1), &views));
  EXPECT_EQ(views[0].border_shift, 0);
  EXPECT_TRUE(std::isinf(views[0].border_shift_slack));
}

// The strongest edges lie elsewhere, so that the nearest ones alone say that
// the masks are too large.
TEST(ShiftBordersToEdges, MovesByAPixelWhereEdgesDisagree) {
  ViewSet views = {MakeViewWithReflection(1.8, 3)};
  const auto edges = ShiftBordersToEdges(Context(1), &views);
  ASSERT_TRUE(edges);
  EXPECT_NEAR(edges->shift, 1.8, 0.1);
  EXPECT_NEAR(edges->strongest_shift, 4.8, 0.2);
  EXPECT_EQ(views[0].border_shift, 1);
  EXPECT_TRUE(std::isinf(views[0].border_shift_slack));
}

// Where texture has edges as strong as the outline, the peak is right, but
// refinement is not bound to it.
TEST(ShiftBordersToEdges, IsNotSureWhereFewEdgesAgree) {
  const PreparedView clear = MakeView(0.6, 0.6, 0.1);
  const PreparedView noise = MakeView(0, 0.2, 0.2, 40);
  ViewSet most = {clear, clear, noise};
  const auto of_most = ShiftBordersToEdges(Context(1), &most);
  ASSERT_TRUE(of_most);
  EXPECT_GT(of_most->share, 0.5);
  EXPECT_FLOAT_EQ(most[0].border_shift_slack, 0.1f);
  ViewSet few = {clear, noise, noise};
  const auto of_few = ShiftBordersToEdges(Context(1), &few);
  ASSERT_TRUE(of_few);
  EXPECT_LT(of_few->share, 0.5);
  EXPECT_NEAR(few[0].border_shift, 0.6, 0.2);
  EXPECT_TRUE(std::isinf(few[0].border_shift_slack));
}

TEST(KeepBorders, LeavesNothingOpen) {
  ViewSet views = {MakeView(3, 0.6, 0.1)};
  KeepBorders(&views);
  EXPECT_EQ(views[0].border_shift, 0);
  EXPECT_EQ(views[0].border_shift_slack, 0);
}

}  // namespace
}  // namespace octacut
