#include "core/views/border_edges.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tests/core/base/recorder.h"
#include "tests/core/views/disc_views.h"
#include "tests/core/views/random_views.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::DiscCoverage;
using testing::Grey;
using testing::kDiscImageSize;
using testing::kDiscRadius;
using testing::MakeDiscView;
using testing::Random;
using testing::ViewOf;

// The same of a photograph that is blurred by `kernel`, in linear light.
PreparedView MakeBlurredView(double shift, const cv::Mat& kernel) {
  Random random(7);
  cv::Mat light(kDiscImageSize, kDiscImageSize, CV_64FC1);
  cv::Mat mask(kDiscImageSize, kDiscImageSize, CV_8UC1);
  for (int y = 0; y < kDiscImageSize; ++y) {
    for (int x = 0; x < kDiscImageSize; ++x) {
      light.at<double>(y, x) = 0.2 + 0.5 * DiscCoverage(x, y, kDiscRadius);
      mask.at<uint8_t>(y, x) =
          uint8_t(std::lround(255 * DiscCoverage(x, y, kDiscRadius + shift)));
    }
  }
  cv::filter2D(light, light, -1, kernel / cv::sum(kernel)[0]);
  cv::Mat image(kDiscImageSize, kDiscImageSize, CV_8UC3);
  for (int y = 0; y < kDiscImageSize; ++y) {
    for (int x = 0; x < kDiscImageSize; ++x) {
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
cv::Mat Disc(double radius) {
  constexpr int kHalf = 4;
  constexpr int kSteps = 10;  // of a pixel
  cv::Mat kernel = cv::Mat::zeros(2 * kHalf + 1, 2 * kHalf + 1, CV_64FC1);
  for (int y = 0; y < kernel.rows * kSteps; ++y) {
    for (int x = 0; x < kernel.cols * kSteps; ++x) {
      const double distance = std::hypot((x + 0.5) / kSteps - kHalf - 0.5,
                                         (y + 0.5) / kSteps - kHalf - 0.5);
      kernel.at<double>(y / kSteps, x / kSteps) += distance < radius;
    }
  }
  return kernel;
}

TEST(MeasureBorderEdges, FindsTheShiftOfMasks) {
  for (const double shift : {-2.3, -0.5, 0.0, 0.4, 3.6}) {
    for (const double object : {0.02, 0.7}) {
      const ViewSet views = {MakeDiscView(shift, object, 0.2)};
      const auto edges = MeasureBorderEdges(views, Context(2));
      ASSERT_TRUE(edges) << shift;
      EXPECT_NEAR(edges->shift, shift, 0.05) << shift << " " << object;
      EXPECT_GT(edges->share, 0.9);
      EXPECT_LT(edges->deviation, 0.2);
    }
  }
}

std::optional<float> LargeShift(const ViewSet& views) {
  return FindLargeShift(
             views, MeasureBorderEdges(views, Context(2)), Context(2))
      .shift;
}

TEST(FindLargeShift, FindsWhatIsOutOfReachOfTheFineMeasurement) {
  for (const double shift : {-9.5, 8.0, 12.2, 14.5}) {
    const auto found = LargeShift({MakeDiscView(shift, 0.7, 0.2)});
    ASSERT_TRUE(found) << shift;
    EXPECT_NEAR(*found, shift, 0.3);
  }
  EXPECT_FALSE(LargeShift({MakeDiscView(22, 0.7, 0.2)}));
}

TEST(FindLargeShift, LeavesWhatTheFineMeasurementFinds) {
  EXPECT_FALSE(LargeShift({MakeDiscView(1, 0.7, 0.2)}));
  EXPECT_FALSE(LargeShift({MakeDiscView(4, 0.7, 0.2)}));
}

TEST(MeasureBorderEdges, FindsTheShiftInBlurredPhotographs) {
  for (const cv::Mat& kernel : {Gaussian(0.6),
                                Gaussian(0.9),
                                Gaussian(1.3),
                                Gaussian(1.8),
                                Gaussian(2.5),
                                Disc(1),
                                Disc(1.3),
                                Disc(1.6),
                                Disc(2),
                                Disc(2.5),
                                Disc(3)}) {
    const auto edges =
        MeasureBorderEdges({MakeBlurredView(0.7, kernel)}, Context(1));
    ASSERT_TRUE(edges);
    EXPECT_NEAR(edges->shift, 0.7, 0.1) << cv::countNonZero(kernel);
  }
}

TEST(MeasureBorderEdges, DoesNotAskClippedEdges) {
  // Four times as bright as what is clipped: the disc looks half a pixel
  // larger.
  const ViewSet views = {MakeDiscView(0, 4, 0.1)};
  EXPECT_FALSE(MeasureBorderEdges(views, Context(1)));
}

// A disc whose mask is too large by `shift` pixels, with a stronger edge so
// many pixels inside its outline: porcelain mirrors the background at grazing
// angles. `rim_light` is the linear light between both, before 0.5 and 0.25.
PreparedView MakeViewWithReflection(double shift,
                                    double inside_pixels,
                                    double rim_light = 0.4) {
  cv::Mat image(kDiscImageSize, kDiscImageSize, CV_8UC3);
  cv::Mat mask(kDiscImageSize, kDiscImageSize, CV_8UC1);
  for (int y = 0; y < kDiscImageSize; ++y) {
    for (int x = 0; x < kDiscImageSize; ++x) {
      const double rim = DiscCoverage(x, y, kDiscRadius);
      const double inside = DiscCoverage(x, y, kDiscRadius - inside_pixels);
      image.at<cv::Vec3b>(y, x) = cv::Vec3b::all(
          Grey((1 - rim) * 0.5 + (rim - inside) * rim_light + inside * 0.25));
      mask.at<uint8_t>(y, x) =
          uint8_t(std::lround(255 * DiscCoverage(x, y, kDiscRadius + shift)));
    }
  }
  return ViewOf(image, mask);
}

TEST(MeasureBorderEdges, PrefersTheOutlineToAStrongerEdgeOfAReflection) {
  const auto edges =
      MeasureBorderEdges({MakeViewWithReflection(0.4, 3)}, Context(1));
  ASSERT_TRUE(edges);
  EXPECT_NEAR(edges->shift, 0.4, 0.1);
}

// The steepest edges lie 0.6 pixels inside the outline of the torus and 0.2
// pixels outside that of the sphere, where the light that is mirrored at the
// outline is a thin line.
TEST(MeasureBorderEdges, FindsTheOutlineOfGlaze) {
  for (const char* kind : {"torus", "sphere"}) {
    SceneSpec spec = testing::TestSpec(kind, 640, 480, 3);
    spec.material = MaterialKind::kPorcelain;
    spec.degrade.pixel_noise = 1;
    const auto edges =
        MeasureBorderEdges(testing::MakeTestScene(spec).views, Context(2));
    ASSERT_TRUE(edges) << kind;
    EXPECT_NEAR(edges->shift, 0, 0.05) << kind;
  }
}

// Linear light of glaze so many pixels inside of the outline of a ball of 190
// pixels: from there on it mirrors less of what is dark behind it (Schlick).
double LightOfGlaze(double inside) {
  const double mirrored = std::pow(1 - std::sqrt(2 * inside / 190), 5);
  return mirrored * 0.25 + (1 - mirrored) * 0.6;
}

// A disc that is darker than the background at its outline, and lighter inside.
PreparedView MakeGlossyDisc() {
  cv::Mat image(kDiscImageSize, kDiscImageSize, CV_8UC3);
  cv::Mat mask(kDiscImageSize, kDiscImageSize, CV_8UC1);
  constexpr int kSteps = 8;  // of a pixel
  for (int y = 0; y < kDiscImageSize; ++y) {
    for (int x = 0; x < kDiscImageSize; ++x) {
      double light = 0;
      for (int k = 0; k < kSteps * kSteps; ++k) {
        const double u = x + (k % kSteps + 0.5) / kSteps;
        const int row = k / kSteps;
        const double v = y + (row + 0.5) / kSteps;
        const double inside =
            kDiscRadius -
            std::hypot(u - kDiscImageSize / 2.0, v - kDiscImageSize / 2.0);
        light += inside < 0 ? 0.4 : LightOfGlaze(inside);
      }
      image.at<cv::Vec3b>(y, x) =
          cv::Vec3b::all(Grey(light / (kSteps * kSteps)));
      mask.at<uint8_t>(y, x) =
          uint8_t(std::lround(255 * DiscCoverage(x, y, kDiscRadius)));
    }
  }
  return ViewOf(image, mask);
}

// The steepest edges lie 1.4 pixels inside.
TEST(MeasureBorderEdges, FindsTheOutlineOfGlossDarkerThanItsBackground) {
  const auto edges = MeasureBorderEdges({MakeGlossyDisc()}, Context(1));
  ASSERT_TRUE(edges);
  EXPECT_NEAR(edges->shift, 0, 0.3);
}

TEST(FindLargeShift, SeesNoPeakInNoiseAndSaysSo) {
  testing::Recorder recorder;
  const Context context(1, &recorder);
  const ViewSet views = {MakeDiscView(0, 0.2, 0.2, 40)};
  const auto edges = MeasureBorderEdges(views, context);
  EXPECT_FALSE(edges);
  EXPECT_FALSE(FindLargeShift(views, edges, context).shift);
  EXPECT_THAT(
      recorder.warnings,
      ::testing::ElementsAre(::testing::HasSubstr("Look at the masks")));
}

TEST(FindLargeShift, SeesNothingWithoutContrast) {
  testing::Recorder recorder;
  const Context context(1, &recorder);
  const ViewSet views = {MakeDiscView(0, 0.2, 0.2, 1)};
  const auto edges = MeasureBorderEdges(views, context);
  EXPECT_FALSE(edges);
  EXPECT_FALSE(FindLargeShift(views, edges, context).shift);
  EXPECT_TRUE(recorder.warnings.empty());
}

// Returns the edges that were measured.
std::optional<BorderEdges> Shift(ViewSet* views) {
  const auto edges = MeasureBorderEdges(*views, Context(2));
  const CoarseShift large = FindLargeShift(*views, edges, Context(2));
  ShiftBordersToEdges(edges, large.is_doubted, views);
  return edges;
}

TEST(ShiftBordersToEdges, GivesTheShiftToAllViews) {
  ViewSet views = {MakeDiscView(0.6, 0.6, 0.1), MakeDiscView(0.6, 0.6, 0.1)};
  views[0].border_shift = 9;
  const auto edges = Shift(&views);
  ASSERT_TRUE(edges);
  for (const PreparedView& view : views) {
    EXPECT_FLOAT_EQ(view.border_shift, float(edges->shift));
    EXPECT_FLOAT_EQ(view.border_shift_slack, 0.1f);
  }
  ViewSet large = {MakeDiscView(3, 0.6, 0.1)};
  Shift(&large);
  EXPECT_NEAR(large[0].border_shift, 3, 0.2);
  EXPECT_FLOAT_EQ(large[0].border_shift_slack, 0.1f);
  // Beyond the range.
  ViewSet beyond = {MakeDiscView(22, 0.6, 0.1)};
  EXPECT_FALSE(Shift(&beyond));
  EXPECT_EQ(beyond[0].border_shift, 0);
  EXPECT_TRUE(std::isinf(beyond[0].border_shift_slack));
  views[0].pyramid = ImagePyramid();
  views[1].pyramid = ImagePyramid();
  EXPECT_FALSE(Shift(&views));
  EXPECT_EQ(views[0].border_shift, 0);
  EXPECT_TRUE(std::isinf(views[0].border_shift_slack));
}

// The strongest edges lie elsewhere, so that the nearest ones alone say that
// the masks are too large.
TEST(ShiftBordersToEdges, MovesByAPixelWhereEdgesDisagree) {
  ViewSet views = {MakeViewWithReflection(1.8, 3)};
  const auto edges = Shift(&views);
  ASSERT_TRUE(edges);
  EXPECT_NEAR(edges->shift, 1.8, 0.1);
  EXPECT_NEAR(edges->strongest_shift, 4.8, 0.2);
  EXPECT_EQ(views[0].border_shift, 1);
  EXPECT_TRUE(std::isinf(views[0].border_shift_slack));
}

// A rim of nearly the background's colour: the masks are right, although most
// edges lie elsewhere.
TEST(ShiftBordersToEdges, KeepsAFaintRim) {
  ViewSet wide = {MakeViewWithReflection(0, 8, 0.45)};
  Shift(&wide);
  EXPECT_NEAR(wide[0].border_shift, 0, 0.1);
  ViewSet narrow = {MakeViewWithReflection(0, 4, 0.45)};
  Shift(&narrow);
  EXPECT_LE(narrow[0].border_shift, 1);
  EXPECT_TRUE(std::isinf(narrow[0].border_shift_slack));
}

// Where texture has edges as strong as the outline, the peak is right, but
// refinement is not bound to it.
TEST(ShiftBordersToEdges, IsNotSureWhereFewEdgesAgree) {
  const PreparedView clear = MakeDiscView(0.6, 0.6, 0.1);
  const PreparedView noise = MakeDiscView(0, 0.2, 0.2, 40);
  ViewSet most = {clear, clear, noise};
  const auto of_most = Shift(&most);
  ASSERT_TRUE(of_most);
  EXPECT_GT(of_most->share, 0.5);
  EXPECT_FLOAT_EQ(most[0].border_shift_slack, 0.1f);
  ViewSet few = {clear, noise, noise};
  const auto of_few = Shift(&few);
  ASSERT_TRUE(of_few);
  EXPECT_LT(of_few->share, 0.5);
  EXPECT_NEAR(few[0].border_shift, 0.6, 0.2);
  EXPECT_TRUE(std::isinf(few[0].border_shift_slack));
}

TEST(KeepBorders, LeavesNothingOpen) {
  ViewSet views = {MakeDiscView(3, 0.6, 0.1)};
  KeepBorders(&views);
  EXPECT_EQ(views[0].border_shift, 0);
  EXPECT_EQ(views[0].border_shift_slack, 0);
}

}  // namespace
}  // namespace octacut
