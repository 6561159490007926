#include "core/visibility/visibility.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "tests/core/base/error_texts.h"
#include "tests/core/crust/labeled_shapes.h"
#include "tests/core/visibility/bare_views.h"

namespace octacut {
namespace {

using testing::Ball;
using testing::BareViews;
using ::testing::HasSubstr;
using testing::LabelSolid;
using testing::Solid;

constexpr int kLevel = 6;
const Eigen::Vector3d kViewedMiddle(0.5, 0.5, 0.5);

Visibility Estimate(const ViewSet& views,
                    const Solid& solid,
                    const VisibilityOptions& options = VisibilityOptions(),
                    const Context& context = Context(2)) {
  const LabeledVoxels surface = LabelSolid(solid, kLevel, 2);
  return Visibility::Estimate(
      views, surface.voxels, surface.labels, kLevel, options, context);
}

double AngleToNormal(const ViewSet& views,
                     int view,
                     const Eigen::Vector3d& point,
                     const Eigen::Vector3d& normal) {
  const Eigen::Vector3d to_camera =
      views[view].projection.center.cast<double>() - point;
  return std::acos(normal.dot(to_camera.normalized())) * 180 / std::numbers::pi;
}

// With a ball alone, every view that is frontal enough sees a point.
TEST(Visibility, SelectsTheMostFrontalViewsOfABall) {
  const ViewSet views = BareViews(testing::DirectionsAllAround(30));
  VisibilityOptions options;
  options.max_views = 5;
  const Visibility visibility =
      Estimate(views, Ball(kViewedMiddle, 0.3), options);
  testing::Random random(1);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d normal = random.Direction();
    const Eigen::Vector3d point = kViewedMiddle + 0.3 * normal;
    std::vector<double> expected;
    for (int v = 0; v < int(views.size()); ++v) {
      const double angle = AngleToNormal(views, v, point, normal);
      if (angle < VisibilityOptions::kMaxAngle) {
        expected.push_back(std::cos(angle * std::numbers::pi / 180));
      }
    }
    std::sort(expected.rbegin(), expected.rend());
    expected.resize(std::min(expected.size(), size_t(5)));
    const Visibility::Selection selection =
        visibility.Select(point.cast<float>(), normal.cast<float>());
    ASSERT_EQ(selection.count, int(expected.size()));
    for (int k = 0; k < selection.count; ++k) {
      EXPECT_NEAR(selection.views[k].weight, expected[k], 1e-4);
      EXPECT_NEAR(std::cos(AngleToNormal(
                               views, selection.views[k].view, point, normal) *
                           std::numbers::pi / 180),
                  expected[k],
                  1e-4);
    }
  }
}

// A pixel of a view four times as far spans 2.4 voxels.
TEST(Visibility, ViewsWithPixelsLargerThanVoxelsWeighLess) {
  const Eigen::Vector3d oblique = Eigen::Vector3d(1, 0, 1.5).normalized();
  const ViewSet views = BareViews({4 * Eigen::Vector3d::UnitZ(), oblique});
  const Visibility visibility = Estimate(views, Ball(kViewedMiddle, 0.3));
  const Eigen::Vector3d point = kViewedMiddle + 0.3 * Eigen::Vector3d::UnitZ();
  const Visibility::Selection selection =
      visibility.Select(point.cast<float>(), Eigen::Vector3f::UnitZ());
  ASSERT_EQ(selection.count, 2);
  EXPECT_EQ(selection.views[0].view, 1);
  EXPECT_NEAR(selection.views[1].weight, 320 / (12 - 0.3) / 64, 1e-3);
}

TEST(Visibility, NoViewSeesTheBack) {
  const ViewSet views = BareViews(
      {Eigen::Vector3d::UnitX(), Eigen::Vector3d(1, 0.2, 0).normalized()});
  const Visibility visibility = Estimate(views, Ball(kViewedMiddle, 0.3));
  EXPECT_EQ(visibility.Select({0.8f, 0.5f, 0.5f}, {1, 0, 0}).count, 2);
  EXPECT_EQ(visibility.Select({0.2f, 0.5f, 0.5f}, {-1, 0, 0}).count, 0);
  EXPECT_EQ(visibility.Select({0.5f, 0.5f, 0.8f}, {0, 0, 1}).count, 0);
  // Even when the normal is wrong: the front hides it.
  EXPECT_EQ(visibility.Select({0.2f, 0.5f, 0.5f}, {1, 0, 0}).count, 0);
  // No normal, no view.
  EXPECT_EQ(visibility.Select({0.8f, 0.5f, 0.5f}, {0, 0, 0}).count, 0);
}

TEST(Visibility, ABallHidesTheOneBehindIt) {
  const Solid first = Ball({0.75, 0.5, 0.5}, 0.15);
  const Solid second = Ball({0.25, 0.5, 0.5}, 0.15);
  const Solid both = [=](const Eigen::Vector3d& x) {
    return std::min(first(x), second(x));
  };
  const ViewSet views = BareViews({Eigen::Vector3d::UnitX(),
                                   Eigen::Vector3d::UnitY(),
                                   Eigen::Vector3d(1, 1, 0).normalized()});
  const Visibility visibility = Estimate(views, both);
  const auto seen_by = [&](const Eigen::Vector3f& point,
                           const Eigen::Vector3f& normal) {
    std::vector<int> seeing;
    const Visibility::Selection selection = visibility.Select(point, normal);
    seeing.reserve(size_t(selection.count));
    for (int k = 0; k < selection.count; ++k) {
      seeing.push_back(selection.views[k].view);
    }
    return seeing;
  };
  // Toward the first camera: the first ball is seen, the second hidden.
  EXPECT_EQ(seen_by({0.9f, 0.5f, 0.5f}, {1, 0, 0}), (std::vector<int>{0, 2}));
  EXPECT_EQ(seen_by({0.4f, 0.5f, 0.5f}, {1, 0, 0}), (std::vector<int>{2}));
  // From the side both are.
  EXPECT_EQ(seen_by({0.75f, 0.65f, 0.5f}, {0, 1, 0}), (std::vector<int>{1, 2}));
  EXPECT_EQ(seen_by({0.25f, 0.65f, 0.5f}, {0, 1, 0}), (std::vector<int>{1, 2}));
}

// What lies a little behind the surface is still to be seen.
TEST(Visibility, TheToleranceIsInVoxelsAlongTheNormal) {
  const ViewSet views = BareViews({Eigen::Vector3d::UnitX()});
  VisibilityOptions options;
  options.depth_tolerance = 4;
  const Visibility visibility =
      Estimate(views, Ball(kViewedMiddle, 0.3), options);
  const auto sees = [&](float depth_in_voxels) {
    const float x = 0.8f - depth_in_voxels / (1 << kLevel);
    return visibility.Select({x, 0.5f, 0.5f}, {1, 0, 0}).count == 1;
  };
  EXPECT_TRUE(sees(-3));
  EXPECT_TRUE(sees(0));
  EXPECT_TRUE(sees(3));
  EXPECT_FALSE(sees(6));
  EXPECT_FALSE(sees(15));
}

TEST(Visibility, PointsOutOfTheFrameAreNotSeen) {
  ViewSet views = BareViews({Eigen::Vector3d::UnitX()});
  views[0].projection.width /= 2;  // the right half is gone
  const Visibility visibility = Estimate(views, Ball(kViewedMiddle, 0.3));
  int seen = 0;
  for (const float y : {0.35f, 0.65f}) {
    const float x = 0.5f + std::sqrt(0.09f - 0.15f * 0.15f);
    const Eigen::Vector3f point(x, y, 0.5f);
    const Eigen::Vector3f normal =
        (point - kViewedMiddle.cast<float>()).normalized();
    seen += visibility.Select(point, normal).count;
  }
  EXPECT_EQ(seen, 1);
}

TEST(Visibility, IsTheSameForAnyNumberOfThreads) {
  const ViewSet views = BareViews(testing::DirectionsAllAround(20));
  const Solid ball = Ball(kViewedMiddle, 0.33);
  const Visibility expected =
      Estimate(views, ball, VisibilityOptions(), Context(1));
  for (const int num_threads : {2, 4}) {
    const Visibility again =
        Estimate(views, ball, VisibilityOptions(), Context(num_threads));
    testing::Random random(2);
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3f point = random.Point(0.1, 0.9).cast<float>();
      const Eigen::Vector3f normal = random.Direction().cast<float>();
      const Visibility::Selection a = expected.Select(point, normal);
      const Visibility::Selection b = again.Select(point, normal);
      ASSERT_EQ(a.count, b.count);
      for (int k = 0; k < a.count; ++k) {
        EXPECT_EQ(a.views[k].view, b.views[k].view);
        EXPECT_EQ(a.views[k].weight, b.views[k].weight);
      }
    }
  }
}

TEST(VisibilityOptions, AreRejectedWithFieldAndConstraint) {
  EXPECT_NO_THROW(VisibilityOptions().Check());
  const auto refusal = [](const auto& change) {
    return RefusalOf<VisibilityOptions>(change);
  };
  EXPECT_THAT(refusal([](auto* o) { o->max_views = 1; }),
              HasSubstr("max_views = 1: must be in 2 .. 16"));
  EXPECT_THAT(refusal([](auto* o) { o->max_views = 17; }),
              HasSubstr("max_views"));
  EXPECT_THAT(refusal([](auto* o) { o->depth_tolerance = 0; }),
              HasSubstr("depth_tolerance = 0: must be positive"));
  EXPECT_THAT(refusal([](auto* o) { o->depth_tolerance = std::nan(""); }),
              HasSubstr("depth_tolerance"));
}

}  // namespace
}  // namespace octacut
