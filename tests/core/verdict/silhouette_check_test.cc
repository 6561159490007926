#include "core/verdict/silhouette_check.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "core/verdict/denied_pixels.h"
#include "tests/core/verdict/sphere_views.h"

namespace octacut {
namespace {

using testing::MakeSphereViews;
using testing::SphereViews;

cv::Mat Square(int x, int y, int side) {
  cv::Mat mask = cv::Mat::zeros(100, 120, CV_8UC1);
  mask(cv::Rect(x, y, side, side)) = 255;
  return mask;
}

PixelCounts Count(const cv::Mat& mask,
                  const cv::Mat& mesh,
                  const BorderUncertainty& uncertainty,
                  const cv::Mat& unknown = cv::Mat()) {
  cv::Mat missed;
  const PixelCounts counts =
      CountPixels(Silhouette(mask, unknown), mesh, uncertainty, &missed);
  EXPECT_EQ(counts.missed, size_t(cv::countNonZero(missed)));
  EXPECT_EQ(counts.object, counts.covered + counts.unsure + counts.missed);
  return counts;
}

TEST(UncertaintyOfBorders, IsAPixelAndWhatIsKnownOfTheMasks) {
  EXPECT_EQ(UncertaintyOfBorders(0, 0).inward, 1);
  EXPECT_EQ(UncertaintyOfBorders(0, 0).outward, 1);
  EXPECT_EQ(UncertaintyOfBorders(3, 0).inward, 4);
  EXPECT_EQ(UncertaintyOfBorders(3, 0).outward, 1);
  EXPECT_EQ(UncertaintyOfBorders(-3, 2).inward, 1);
  EXPECT_EQ(UncertaintyOfBorders(-3, 2).outward, 4);
  EXPECT_EQ(UncertaintyOfBorders(0, 2).outward, 3);
}

TEST(CountPixels, PixelsBesideTheBorderAreUnsure) {
  // A ring of one pixel is uncovered: 40^2 - 38^2.
  const PixelCounts counts =
      Count(Square(20, 30, 40), Square(21, 31, 38), {1, 1});
  EXPECT_EQ(counts.object, 1600u);
  EXPECT_EQ(counts.covered, 1444u);
  EXPECT_EQ(counts.border, 156u);
  EXPECT_EQ(counts.unsure, 156u);
  EXPECT_EQ(counts.missed, 0u);
}

TEST(CountPixels, FartherInsideTheyAreMissed) {
  const PixelCounts counts =
      Count(Square(20, 30, 40), Square(22, 32, 36), {1, 1});
  EXPECT_EQ(counts.unsure, 156u);
  EXPECT_EQ(counts.missed, 1444u - 36u * 36u);
  // Masks that are known to be a pixel too large excuse it.
  EXPECT_EQ(Count(Square(20, 30, 40), Square(22, 32, 36), {2, 1}).missed, 0u);
}

TEST(CountPixels, BackgroundIsExceeded) {
  const PixelCounts counts =
      Count(Square(20, 30, 40), Square(18, 28, 44), {1, 1});
  EXPECT_EQ(counts.covered, 1600u);
  EXPECT_EQ(counts.exceeded, 44u * 44u - 1600u);
  EXPECT_GT(counts.surely_exceeded, 0u);
  EXPECT_LT(counts.surely_exceeded, counts.exceeded);
  EXPECT_EQ(
      Count(Square(20, 30, 40), Square(18, 28, 44), {1, 3}).surely_exceeded,
      0u);
}

TEST(CountPixels, WhatNoPhotographCoversIsNoObject) {
  // The mask reaches the edge of the frame, the photograph does not.
  const cv::Mat mask = Square(0, 30, 40);
  cv::Mat mesh = mask.clone();
  mesh(cv::Rect(0, 0, 10, 100)) = 0;
  EXPECT_GT(Count(mask, mesh, {1, 1}).missed, 300u);
  cv::Mat unknown = cv::Mat::zeros(mask.size(), CV_8UC1);
  unknown(cv::Rect(0, 0, 10, 100)) = 255;
  const PixelCounts counts = Count(mask, mesh, {1, 1}, unknown);
  EXPECT_EQ(counts.missed, 0u);
  EXPECT_EQ(counts.object, 1200u);
}

TEST(CheckSilhouettes, TheObjectItselfFillsThem) {
  const SphereViews sphere = MakeSphereViews();
  const MaskCheck check = sphere.Check(sphere.Ball(1)).repaired;
  EXPECT_GT(check.total.object, 20000u);
  EXPECT_EQ(check.total.missed, 0u);
  EXPECT_EQ(check.total.surely_exceeded, 0u);
  EXPECT_LT(double(check.total.unsure), 0.01 * double(check.total.object));
}

TEST(CheckSilhouettes, ASmallerBallMissesPixelsThatNoMaskDenies) {
  const SphereViews sphere = MakeSphereViews();
  const MaskCheck check = sphere.Check(sphere.Ball(0.9)).repaired;
  EXPECT_GT(double(check.total.missed), 0.1 * double(check.total.object));
  EXPECT_EQ(check.total.contradicted, 0u);
  EXPECT_EQ(check.views.size(), sphere.test.views.size());
}

TEST(CheckSilhouettes, HoldsTheMeshAgainstBothMasks) {
  SphereViews sphere = MakeSphereViews();
  sphere.given = sphere.test.scene.views;
  sphere.given[2].mask = sphere.given[2].mask.clone();
  cv::Mat& mask = sphere.given[2].mask;
  mask(cv::Rect(mask.cols / 2 - 5, mask.rows / 2 - 5, 10, 10)) = 0;
  const SilhouetteCheck check = sphere.Check(sphere.Ball(1));
  EXPECT_EQ(check.repaired.total.exceeded + 100, check.given.total.exceeded);
  EXPECT_EQ(check.given.views[2].object + 100, check.repaired.views[2].object);
}

TEST(CheckSilhouettes, NamesTheMaskThatDeniesWhatOthersShow) {
  // The mask of one view lacks its left half.
  SphereViews sphere = MakeSphereViews();
  View& view = sphere.test.scene.views[3];
  view.mask = view.mask.clone();
  view.mask(cv::Rect(0, 0, view.mask.cols / 2, view.mask.rows)) = 0;
  sphere.test.views[3].silhouette = Silhouette(view.mask);
  sphere.given = sphere.test.scene.views;
  // The hull of the masks is half a ball.
  const IndexedMesh half = sphere.BallBeside(3);
  const MaskCheck check = sphere.Check(half).repaired;
  EXPECT_GT(check.total.missed, 1000u);
  EXPECT_GT(double(check.total.contradicted), 0.8 * double(check.total.missed));
  EXPECT_EQ(check.views[3].missed, 0u);
  for (size_t i = 0; i < check.views.size(); ++i) {
    if (i != 3) {
      EXPECT_LT(10 * check.denied_of_others[i], check.denied_of_others[3]) << i;
    }
  }
}

TEST(CheckSilhouettes, IsTheSameForAnyNumberOfThreads) {
  const SphereViews sphere = MakeSphereViews();
  const IndexedMesh ball = sphere.Ball(0.9);
  const SilhouetteCheck one = sphere.Check(ball, Context(1));
  const SilhouetteCheck two = sphere.Check(ball, Context(2));
  for (size_t i = 0; i < one.repaired.views.size(); ++i) {
    EXPECT_EQ(one.repaired.views[i].missed, two.repaired.views[i].missed);
    EXPECT_EQ(one.repaired.views[i].exceeded, two.repaired.views[i].exceeded);
  }
}

}  // namespace
}  // namespace octacut
