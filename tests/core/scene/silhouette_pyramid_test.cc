#include "core/scene/silhouette_pyramid.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/scene/synthetic_views.h"

namespace octacut {
namespace {

using testing::RenderView;
using testing::Sphere;

const Eigen::Vector3d kMiddle(0.3, -0.2, 0.1);

Eigen::AlignedBox3d CubeAt(const Eigen::Vector3d& center, double edge) {
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(edge / 2);
  return {center - half, center + half};
}

TEST(SilhouettePyramid, IsClosedUnlessTheObjectTouchesTheFrame) {
  const Eigen::Vector3d eye(4, 0, 0);
  EXPECT_TRUE(
      SilhouettePyramid(RenderView(eye, kMiddle, 300, Sphere(kMiddle, 1)))
          .IsClosed());
  EXPECT_FALSE(
      SilhouettePyramid(RenderView(eye, kMiddle, 600, Sphere(kMiddle, 1)))
          .IsClosed());
  const SilhouettePyramid empty(
      RenderView(eye, kMiddle, 300, Sphere({9, 9, 9}, 0.1)));
  EXPECT_FALSE(empty.HasObject());
  EXPECT_FALSE(empty.IsClosed());
}

TEST(SilhouettePyramid, CountsCoverageOfHalfAsObject) {
  View view = RenderView({4, 0, 0}, kMiddle, 300, Sphere({9, 9, 9}, 0.1));
  view.mask.at<uint8_t>(100, 100) = 127;
  EXPECT_FALSE(SilhouettePyramid(view).HasObject());
  view.mask.at<uint8_t>(100, 100) = 128;
  EXPECT_TRUE(SilhouettePyramid(view).HasObject());
}

TEST(SilhouettePyramid, BehindAClosedViewIsBackgroundBehindAnOpenOneUnknown) {
  const Eigen::Vector3d eye(4, 0, 0);
  const auto behind = CubeAt({8, 0, 0}, 0.5);
  const SilhouettePyramid closed(
      RenderView(eye, kMiddle, 300, Sphere(kMiddle, 1)));
  const SilhouettePyramid open(
      RenderView(eye, kMiddle, 900, Sphere(kMiddle, 1)));
  EXPECT_EQ(closed.Classify(behind), BoxVerdict::kBackground);
  EXPECT_EQ(open.Classify(behind), BoxVerdict::kUnknown);
  EXPECT_EQ(closed.Classify(behind.center()), BoxVerdict::kBackground);
  EXPECT_EQ(open.Classify(behind.center()), BoxVerdict::kUnknown);
  // Beside the frame.
  const auto beside = CubeAt({0, 6, 0}, 0.5);
  EXPECT_EQ(closed.Classify(beside), BoxVerdict::kBackground);
  EXPECT_EQ(open.Classify(beside), BoxVerdict::kUnknown);
}

// Against points sampled in random boxes of all sizes.
TEST(SilhouettePyramid, NeverContradictsThePointsOfABox) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> unit(0, 1);
  size_t decided = 0;
  for (const double focal : {300.0, 700.0}) {
    const SilhouettePyramid silhouette(
        RenderView({3, 1, 2}, kMiddle, focal, Sphere(kMiddle, 0.8)));
    for (int trial = 0; trial < 4000; ++trial) {
      const Eigen::Vector3d corner = Eigen::Vector3d::NullaryExpr(
          [&] { return -3 + 7 * unit(generator); });
      const double edge = std::pow(10.0, -3 + 3.5 * unit(generator));
      const Eigen::AlignedBox3d box(corner,
                                    corner + Eigen::Vector3d::Constant(edge));
      const BoxVerdict verdict = silhouette.Classify(box);
      if (verdict == BoxVerdict::kMixed) {
        continue;
      }
      ++decided;
      for (int sample = 0; sample < 20; ++sample) {
        const Eigen::Vector3d point =
            corner + edge * Eigen::Vector3d::NullaryExpr(
                                [&] { return unit(generator); });
        EXPECT_EQ(silhouette.Classify(point), verdict);
      }
    }
  }
  EXPECT_GT(decided, 2000u);
}

TEST(SilhouettePyramid, TrustedSidesBoundAnOpenView) {
  // The object leaves the frame at the left or right only.
  View view = RenderView({4, 0, 0},
                         {0, 0, 0},
                         300,
                         testing::Box({Eigen::Vector3d(-0.2, 0, -0.3),
                                       Eigen::Vector3d(0.2, 9, 0.3)}));
  const auto above = CubeAt({0, 0, 5}, 0.5);
  EXPECT_EQ(SilhouettePyramid(view, false).Classify(above),
            BoxVerdict::kUnknown);
  EXPECT_EQ(SilhouettePyramid(view, true).Classify(above),
            BoxVerdict::kBackground);
  const auto object = CubeAt({0, 8, 0}, 0.2);
  EXPECT_NE(SilhouettePyramid(view, true).Classify(object),
            BoxVerdict::kBackground);
}

}  // namespace
}  // namespace octacut
