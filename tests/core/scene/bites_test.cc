#include "core/scene/bites.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "core/scene/region.h"
#include "tests/core/scene/synthetic_views.h"

namespace octacut {
namespace {

using ::testing::IsEmpty;

using testing::Box;
using testing::RenderAllAround;

constexpr double kTolerance = 2;
constexpr double kTip = 0.8;
constexpr double kHalfWidth = 0.06;

// 28 views of a block with a rod along x.
std::vector<View> RenderRod(double tip) {
  const auto block = Box(Eigen::AlignedBox3d(Eigen::Vector3d(-0.4, -0.3, -0.3),
                                             Eigen::Vector3d(0.2, 0.3, 0.3)));
  const auto rod =
      Box(Eigen::AlignedBox3d(Eigen::Vector3d(0, -kHalfWidth, -kHalfWidth),
                              Eigen::Vector3d(tip, kHalfWidth, kHalfWidth)));
  return RenderAllAround(
      {0, 0, 0},
      4,
      500,
      [&](const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
        return block(origin, direction) || rod(origin, direction);
      });
}

std::vector<View> Views() {
  static const std::vector<View> views = RenderRod(kTip);
  std::vector<View> copies = views;
  for (View& view : copies) {
    view.mask = view.mask.clone();
  }
  return copies;
}

Eigen::Vector2d Pixel(const View& view, const Eigen::Vector3d& point) {
  return view.camera.Project(view.cam_from_world * point);
}

// Takes a disc of 14 pixels' radius about the rod's tip out of the mask.
void BiteOffTip(View* view) {
  const Eigen::Vector2d tip = Pixel(*view, {kTip, 0, 0});
  cv::circle(
      view->mask, {int(tip.x()), int(tip.y())}, 14, cv::Scalar(0), cv::FILLED);
}

// A view that has the rod free of the block, as `skipped` others do.
size_t ViewFromSide(const std::vector<View>& views, int skipped) {
  for (size_t v = 0; v < views.size(); ++v) {
    const Eigen::Vector3d towards = views[v].Center().normalized();
    if (std::abs(towards.x()) < 0.3 && skipped-- == 0) {
      return v;
    }
  }
  return 0;
}

void Fill(const std::vector<Bite>& bites, std::vector<View>* views) {
  for (const Bite& bite : bites) {
    (*views)[bite.view].mask.setTo(255, bite.pixels);
  }
}

double TipOfRegion(const std::vector<View>& views) {
  return EstimateRegion(views, {}, {}, Context(2)).box.max().x();
}

TEST(FindBites, RightMasksHaveNone) {
  EXPECT_THAT(FindBites(Views(), 0, Context(2)), IsEmpty());
}

TEST(FindBites, MasksOffByAPixelHaveNone) {
  std::vector<View> views = Views();
  for (size_t v = 0; v < views.size(); ++v) {
    const cv::Mat cross = cv::Mat::ones(3, 3, CV_8UC1);
    cv::Mat& mask = views[v].mask;
    v % 2 ? cv::erode(mask, mask, cross) : cv::dilate(mask, mask, cross);
  }
  EXPECT_THAT(FindBites(views, kTolerance, Context(2)), IsEmpty());
}

TEST(FindBites, ARodKeepsItsTip) {
  const std::vector<View> exact = Views();
  std::vector<View> views = Views();
  const size_t bitten = ViewFromSide(views, 1);
  BiteOffTip(&views[bitten]);
  const double voxel = 1.2 / 64;
  ASSERT_LT(TipOfRegion(views), TipOfRegion(exact) - 2 * voxel);

  const std::vector<Bite> bites = FindBites(views, kTolerance, Context(2));
  ASSERT_EQ(bites.size(), 1u);
  EXPECT_EQ(bites[0].view, bitten);
  Fill(bites, &views);
  EXPECT_NEAR(TipOfRegion(views), TipOfRegion(exact), voxel);
  // No more than the slack is filled beyond what the mask had.
  cv::Mat grown;
  cv::dilate(exact[bitten].mask, grown, cv::Mat::ones(7, 7, CV_8UC1));
  EXPECT_EQ(cv::countNonZero(views[bitten].mask & ~grown), 0);
}

TEST(FindBites, ATipMayBeMissingInTwoMasks) {
  const std::vector<View> exact = Views();
  std::vector<View> views = Views();
  const size_t first = ViewFromSide(views, 1);
  const size_t second = ViewFromSide(views, 3);
  BiteOffTip(&views[first]);
  BiteOffTip(&views[second]);
  Fill(FindBites(views, kTolerance, Context(2)), &views);
  EXPECT_NEAR(TipOfRegion(views), TipOfRegion(exact), 1.2 / 64);
}

// The hull of the others fills the gap between two plates that the views from
// the ends see through, but none of them lacks an explanation for it.
TEST(FindBites, AreNotWhatFewViewsSeeThrough) {
  const auto left = Box(Eigen::AlignedBox3d(Eigen::Vector3d(-0.4, -0.2, -0.3),
                                            Eigen::Vector3d(0.4, -0.04, 0.3)));
  const auto right = Box(Eigen::AlignedBox3d(Eigen::Vector3d(-0.4, 0.04, -0.3),
                                             Eigen::Vector3d(0.4, 0.2, 0.3)));
  const auto floor = Box(Eigen::AlignedBox3d(Eigen::Vector3d(0.2, -0.2, -0.3),
                                             Eigen::Vector3d(0.4, 0.2, 0.3)));
  const std::vector<View> views = RenderAllAround(
      {0, 0, 0},
      4,
      500,
      [&](const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
        return left(origin, direction) || right(origin, direction) ||
               floor(origin, direction);
      });
  EXPECT_THAT(FindBites(views, 0, Context(2)), IsEmpty());
}

TEST(FindBites, WhatManyDenyStays) {
  std::vector<View> views = Views();
  const std::vector<View> shorter = RenderRod(0.6);
  for (size_t v = 0; v < views.size(); v += 4) {
    views[v].mask = shorter[v].mask;
  }
  EXPECT_THAT(FindBites(views, kTolerance, Context(2)), IsEmpty());
}

TEST(FindBites, AreTheSameForAnyNumberOfThreads) {
  std::vector<View> views = Views();
  BiteOffTip(&views[ViewFromSide(views, 1)]);
  BiteOffTip(&views[ViewFromSide(views, 2)]);
  const std::vector<Bite> one = FindBites(views, kTolerance, Context(1));
  const std::vector<Bite> three = FindBites(views, kTolerance, Context(3));
  ASSERT_FALSE(one.empty());
  ASSERT_EQ(one.size(), three.size());
  for (size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].view, three[i].view);
    EXPECT_EQ(cv::norm(one[i].pixels, three[i].pixels, cv::NORM_INF), 0);
  }
}

TEST(FindBites, NeedViewsThatBoundTheObject) {
  const std::vector<View> views = Views();
  EXPECT_THAT(FindBites({views[0], views[1], views[2]}, 0, Context(1)),
              IsEmpty());
  EXPECT_THAT(
      FindBites({views[0], views[0], views[0], views[0]}, 0, Context(1)),
      IsEmpty());
}

}  // namespace
}  // namespace octacut
