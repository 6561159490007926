#include "core/scene/contradictions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "tests/core/scene/synthetic_views.h"

namespace octacut {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using testing::Box;
using testing::RenderAllAround;

// 28 views of an object that no mirror maps onto itself: two boxes, of which
// one stands at the end of the other.
std::vector<View> ConsistentViews() {
  static const std::vector<View> kViews = [] {
    const auto lying = Box(Eigen::AlignedBox3d(
        Eigen::Vector3d(-0.5, -0.15, -0.2), Eigen::Vector3d(0.5, 0.15, 0)));
    const auto standing = Box(Eigen::AlignedBox3d(
        Eigen::Vector3d(0.2, -0.15, 0), Eigen::Vector3d(0.5, 0.05, 0.5)));
    return RenderAllAround(
        {0, 0, 0},
        4,
        700,
        [&](const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
          return lying(origin, direction) || standing(origin, direction);
        });
  }();
  std::vector<View> copies = kViews;
  for (View& view : copies) {
    view.mask = view.mask.clone();
  }
  return copies;
}

void Shift(double x, double y, View* view) {
  const cv::Matx23d by(1, 0, x, 0, 1, y);
  cv::warpAffine(
      view->mask.clone(), view->mask, by, view->mask.size(), cv::INTER_NEAREST);
}

Contradictions Find(const std::vector<View>& views, int num_threads = 2) {
  return FindContradictions(views, Context(num_threads));
}

std::vector<size_t> NumbersOf(const Contradictions& contradictions) {
  std::vector<size_t> numbers;
  for (const ContradictingView& view : contradictions.views) {
    numbers.push_back(view.view);
  }
  return numbers;
}

TEST(FindContradictions, GoodViewsFit) {
  const Contradictions found = Find(ConsistentViews());
  EXPECT_TRUE(found.is_judged);
  EXPECT_THAT(found.views, IsEmpty());
  EXPECT_LT(found.largest_left.unexplained, 0.005);
  EXPECT_LT(found.largest_left.taken, 0.0005);
}

TEST(FindContradictions, MasksOffByPixelsFit) {
  std::vector<View> views = ConsistentViews();
  for (size_t v = 0; v < views.size(); ++v) {
    const cv::Mat cross = cv::Mat::ones(5, 5, CV_8UC1);
    cv::Mat& mask = views[v].mask;
    v % 2 ? cv::erode(mask, mask, cross) : cv::dilate(mask, mask, cross);
  }
  EXPECT_THAT(Find(views).views, IsEmpty());
}

TEST(FindContradictions, ObjectsThatLeaveTheFrameFit) {
  std::vector<View> views = ConsistentViews();
  for (size_t v = 0; v < views.size(); v += 2) {
    // The left half of the photograph is all there is.
    views[v].mask = views[v].mask(cv::Rect(0, 0, 170, 240)).clone();
    views[v].camera.width = 170;
  }
  EXPECT_THAT(Find(views).views, IsEmpty());
}

TEST(FindContradictions, ShiftedMask) {
  std::vector<View> views = ConsistentViews();
  Shift(16, 0, &views[5]);
  const Contradictions found = Find(views);
  ASSERT_THAT(NumbersOf(found), ElementsAre(5));
  EXPECT_TRUE(found.views[0].is_grave);
  EXPECT_GT(found.views[0].fit.unexplained, 0.05);
  EXPECT_GT(found.views[0].fit.taken, 0.01);
}

TEST(FindContradictions, MirroredMask) {
  std::vector<View> views = ConsistentViews();
  cv::flip(views[8].mask.clone(), views[8].mask, 1);
  EXPECT_THAT(NumbersOf(Find(views)), ElementsAre(8));
}

TEST(FindContradictions, ExchangedMasks) {
  std::vector<View> views = ConsistentViews();
  std::swap(views[3].mask, views[12].mask);
  EXPECT_THAT(NumbersOf(Find(views)), ElementsAre(3, 12));
}

TEST(FindContradictions, ExchangedPoses) {
  std::vector<View> views = ConsistentViews();
  std::swap(views[3].cam_from_world, views[12].cam_from_world);
  EXPECT_THAT(NumbersOf(Find(views)), ElementsAre(3, 12));
}

TEST(FindContradictions, MaskOfAPartOfTheObject) {
  std::vector<View> views = ConsistentViews();
  views[6].mask.rowRange(0, 120).setTo(0);
  EXPECT_THAT(NumbersOf(Find(views)), ElementsAre(6));
}

TEST(FindContradictions, ThingBesideTheObjectIsNotGrave) {
  std::vector<View> views = ConsistentViews();
  cv::Mat& mask = views[6].mask;
  const cv::Rect extent = cv::boundingRect(mask);
  const int side = int(std::sqrt(0.17 * cv::countNonZero(mask)));
  mask(cv::Rect(extent.br().x - 2, extent.br().y - side, side, side))
      .setTo(255);
  const Contradictions found = Find(views);
  ASSERT_THAT(NumbersOf(found), ElementsAre(6));
  EXPECT_FALSE(found.views[0].is_grave);
}

TEST(FindContradictions, ThirdOfTheViews) {
  std::vector<View> views = ConsistentViews();
  std::vector<size_t> bad;
  for (size_t v = 0; v < 27; v += 3) {
    bad.push_back(v);
    Shift(v % 2 ? 60 : -60, double(v), &views[v]);
  }
  EXPECT_EQ(NumbersOf(Find(views)), bad);
}

TEST(FindContradictions, IsTheSameForAnyNumberOfThreads) {
  std::vector<View> views = ConsistentViews();
  Shift(16, 0, &views[5]);
  Shift(0, 12, &views[20]);
  const Contradictions a = Find(views, 1);
  const Contradictions b = Find(views, 3);
  ASSERT_EQ(NumbersOf(a), NumbersOf(b));
  for (size_t i = 0; i < a.views.size(); ++i) {
    EXPECT_EQ(a.views[i].fit.unexplained, b.views[i].fit.unexplained);
    EXPECT_EQ(a.views[i].fit.taken, b.views[i].fit.taken);
  }
}

TEST(FindContradictions, ThreeViewsAreNotJudged) {
  std::vector<View> views = ConsistentViews();
  views.resize(3);
  EXPECT_FALSE(Find(views).is_judged);
}

}  // namespace
}  // namespace octacut
